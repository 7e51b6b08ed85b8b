/**
 * Pictures and vectors as pixels.
 */

/** @param {Blob} blob @returns {Promise<string>} its contents as an address */
export function dataAddress(blob) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result));
    reader.onerror = () => reject(reader.error);
    reader.readAsDataURL(blob);
  });
}

/** An SVG text as an image. @param {string} svg @returns {Promise<HTMLImageElement>} */
export async function imageOf(svg) {
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    return image;
  } finally {
    URL.revokeObjectURL(address);
  }
}

/**
 * A figure as PNG: its pictures pixel by pixel, and over them the rest.
 *
 * @param {{ width: number, height: number, background: string }} size
 * @param {readonly { picture: Blob, box: import("./layout.js").Box }[]} pictures
 * @param {string} over SVG
 * @returns {Promise<Blob>}
 */
export async function rasterised({ width, height, background }, pictures, over) {
  const canvas = document.createElement("canvas");
  canvas.width = width;
  canvas.height = height;
  const pen = canvas.getContext("2d");
  if (!pen) throw new Error(`this browser can't draw a figure of ${width} x ${height} pixels`);
  if (background !== "none") {
    pen.fillStyle = background;
    pen.fillRect(0, 0, width, height);
  }
  for (const { picture, box } of pictures) {
    const bitmap = await createImageBitmap(picture);
    pen.drawImage(bitmap, box.x, box.y, box.width, box.height);
    bitmap.close();
  }
  pen.drawImage(await imageOf(over), 0, 0, width, height);
  return new Promise((resolve, reject) =>
    canvas.toBlob(
      (blob) => (blob ? resolve(blob) : reject(new Error("the figure could not be written as PNG"))),
      "image/png",
    ),
  );
}

/**
 * What of pictures is not transparent, as parts of their sides; of all together. Null where nothing is drawn.
 *
 * @param {readonly Blob[]} pictures of one size
 * @returns {Promise<{ left: number, top: number, right: number, bottom: number } | null>}
 */
export async function contentOf(pictures) {
  let [left, top, right, bottom] = [1, 1, 0, 0];
  for (const picture of pictures) {
    const bitmap = await createImageBitmap(picture);
    const { width, height } = bitmap;
    const canvas = new OffscreenCanvas(width, height);
    const pen = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d"));
    pen.drawImage(bitmap, 0, 0);
    const { data } = pen.getImageData(0, 0, width, height);
    for (let y = 0; y < height; y++)
      for (let x = 0; x < width; x++) {
        if (!data[4 * (y * width + x) + 3]) continue;
        left = Math.min(left, x / width);
        right = Math.max(right, (x + 1) / width);
        top = Math.min(top, y / height);
        bottom = Math.max(bottom, (y + 1) / height);
      }
  }
  return right > left ? { left, top, right, bottom } : null;
}

/**
 * A part of a picture.
 *
 * @param {Blob} picture @param {{ x: number, y: number, width: number, height: number }} part in its pixels
 * @returns {Promise<Blob>} PNG
 */
export async function cropped(picture, { x, y, width, height }) {
  const bitmap = await createImageBitmap(picture, x, y, width, height);
  const canvas = new OffscreenCanvas(width, height);
  /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d")).drawImage(bitmap, 0, 0);
  return canvas.convertToBlob({ type: "image/png" });
}
