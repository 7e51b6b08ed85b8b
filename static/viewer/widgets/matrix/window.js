/**
 * The part of a square matrix that is looked at: it begins at `x`, `y` and is `size` things wide, all in things and not always whole
 * ones. Points are given as shares of its width, 0 to 1.
 *
 * @typedef {{ x: number, y: number, size: number }} Window
 * @typedef {{ x: number, y: number }} Point
 */

/** No fewer things are looked at, so that the way back is seen. */
const LEAST = 4;

/** All of the matrix. @param {number} count of things @returns {Window} */
export function whole(count) {
  return { x: 0, y: 0, size: count };
}

/** @param {Window} window @param {number} count */
export function isWhole({ size }, count) {
  return size >= count;
}

/** Whether there is a way nearer, or back; at the last step nearer too, so that a hand that goes on does nothing else. @param {Window} window @param {number} factor @param {number} count */
export function leadsSomewhere(window, factor, count) {
  return factor > 1 ? count > LEAST : !isWhole(window, count);
}

/** Nearer by a factor; the point stays where it is. @param {Window} window @param {number} factor @param {Point} point @param {number} count @returns {Window} */
export function zoomed({ x, y, size }, factor, point, count) {
  const next = Math.min(count, Math.max(Math.min(LEAST, count), size / factor));
  return inside({ x: x + point.x * (size - next), y: y + point.y * (size - next), size: next }, count);
}

/** Moved with a hand that drags it. @param {Window} window @param {Point} by shares of the width @param {number} count @returns {Window} */
export function dragged({ x, y, size }, by, count) {
  return inside({ x: x - by.x * size, y: y - by.y * size, size }, count);
}

/** Moved as little as brings a cell into sight. @param {Window} window @param {import("./pair_index.js").Place} place @param {number} count @returns {Window} */
export function reaching({ x, y, size }, { row, column }, count) {
  const along = (/** @type {number} */ start, /** @type {number} */ cell) =>
    Math.min(cell, Math.max(start, cell + 1 - size));
  return inside({ x: along(x, column), y: along(y, row), size }, count);
}

/** The cell under a point. @param {Window} window @param {Point} point @param {number} count @returns {import("./pair_index.js").Place} */
export function placeUnder({ x, y, size }, point, count) {
  const thing = (/** @type {number} */ value) => Math.max(0, Math.min(count - 1, Math.floor(value)));
  return { row: thing(y + point.y * size), column: thing(x + point.x * size) };
}

/** The middle of a cell as a point. @param {Window} window @param {import("./pair_index.js").Place} place @returns {Point} */
export function pointOf({ x, y, size }, { row, column }) {
  return { x: (column + 0.5 - x) / size, y: (row + 0.5 - y) / size };
}

/** @param {Window} window @param {number} count @returns {Window} */
function inside({ x, y, size }, count) {
  const clamped = (/** @type {number} */ start) => Math.max(0, Math.min(count - size, start));
  return { x: clamped(x), y: clamped(y), size };
}
