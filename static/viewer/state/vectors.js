/**
 * The little algebra that camera and plane need on [x, y, z].
 *
 * @typedef {readonly [number, number, number]} Vector
 */

/** @param {Vector} a @param {Vector} b */
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** @param {Vector} a @param {number} s @returns {Vector} */
export const scaled = (a, s) => [a[0] * s, a[1] * s, a[2] * s];

/** The vector's direction; x where it has none. @param {Vector} a @returns {Vector} */
export function normalised(a) {
  const length = Math.hypot(...a);
  return length > 0 ? scaled(a, 1 / length) : [1, 0, 0];
}

/** The signed axis nearest to a direction. @param {Vector} a @returns {Vector} */
export function nearestAxis(a) {
  const sizes = a.map(Math.abs);
  const axis = sizes.indexOf(Math.max(...sizes));
  const along = (/** @type {number} */ index) => (index === axis ? Math.sign(a[axis]) || 1 : 0);
  return [along(0), along(1), along(2)];
}
