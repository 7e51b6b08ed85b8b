/**
 * The little algebra that camera and plane need on [x, y, z].
 *
 * @typedef {readonly [number, number, number]} Vector
 */

/** @param {Vector} a @param {Vector} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {Vector} a @param {number} s @returns {Vector} */
export const scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];

/** The vector's direction, whatever its length; x where it has none. @param {Vector} a @returns {Vector} */
export function normalised(a) {
  const largest = Math.max(...a.map(Math.abs));
  if (!(largest > 0)) return [1, 0, 0];
  /** @type {Vector} */
  const near = [a[0] / largest, a[1] / largest, a[2] / largest];
  return scaled(near, 1 / Math.hypot(...near));
}

/** The signed axis nearest to a direction. @param {Vector} a @returns {Vector} */
export function nearestAxis(a) {
  const sizes = a.map(Math.abs);
  const axis = sizes.indexOf(Math.max(...sizes));
  const along = (/** @type {number} */ index) => (index === axis ? Math.sign(a[axis]) || 1 : 0);
  return [along(0), along(1), along(2)];
}
