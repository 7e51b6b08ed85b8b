/** Pixels of a figure's side, at most. */
export const LARGEST = 8192;

/**
 * How large a picture has to be taken, and what part of it is kept, so that its content fills a box one way.
 *
 * @param {{ left: number, top: number, right: number, bottom: number }} content parts of the picture's sides @param {import("./layout.js").Box} box
 * @returns {{ whole: { width: number, height: number }, part: import("./layout.js").Box }}
 */
export function cutTo({ left, top, right, bottom }, box) {
  const grow = Math.min(1 / (right - left), 1 / (bottom - top), LARGEST / Math.max(box.width, box.height));
  const whole = { width: Math.round(box.width * grow), height: Math.round(box.height * grow) };
  const x = Math.floor(left * whole.width);
  const y = Math.floor(top * whole.height);
  return {
    whole,
    part: {
      x,
      y,
      width: Math.max(1, Math.ceil(right * whole.width) - x),
      height: Math.max(1, Math.ceil(bottom * whole.height) - y),
    },
  };
}
