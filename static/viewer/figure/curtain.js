/** Pixels of the line where two pictures meet, in a picture of so many. */
const LINE = 1 / 1200;

/**
 * Two pictures upon each other: left of a line the one, right of it the other.
 *
 * @param {Blob} left @param {Blob} right of the same size @param {number} at where they meet, 0 to 1
 * @returns {Promise<Blob>} PNG
 */
export async function curtained(left, right, at) {
  const [a, b] = await Promise.all([left, right].map((picture) => createImageBitmap(picture)));
  const { width, height } = a;
  const canvas = new OffscreenCanvas(width, height);
  const pen = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d"));
  const place = Math.round(at * width);
  const draw = (/** @type {ImageBitmap} */ picture, /** @type {number} */ from, /** @type {number} */ to) =>
    to > from && pen.drawImage(picture, from, 0, to - from, height, from, 0, to - from, height);
  draw(a, 0, place);
  draw(b, place, width);
  const line = Math.max(1, Math.round(width * LINE)); // of whole pixels, or it would be blurred
  pen.fillStyle = "#85888d";
  pen.fillRect(Math.round(place - line / 2), 0, line, height);
  for (const picture of [a, b]) picture.close();
  return canvas.convertToBlob({ type: "image/png" });
}
