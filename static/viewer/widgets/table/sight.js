/**
 * What of a long list of rows of one height is in sight. All lengths are in pixels, the head left out.
 *
 * @typedef {object} Sight
 * @property {number} top how far it is scrolled
 * @property {number} height of the window through which it is seen
 * @property {number} row height of a row
 * @property {number} rows how many there are
 */

/** Rows that are kept ready above and below those in sight. */
const SPARE = 6;

/** The places of the rows to be there: from the first to before the last. @param {Sight} sight @returns {[first: number, end: number]} */
export function rowsToDraw({ top, height, row, rows }) {
  if (!(row > 0) || !(height > 0)) return [0, 0];
  const first = Math.max(0, Math.floor(top / row) - SPARE);
  return [Math.min(first, rows), Math.min(rows, Math.ceil((top + height) / row) + SPARE)];
}

/** Whether all of a row is in sight. @param {number} place @param {Sight} sight */
export function isInSight(place, { top, height, row }) {
  return place * row >= top && (place + 1) * row <= top + height;
}

/** How far to scroll for a row to be in sight, no further than is needed. @param {number} place @param {Sight} sight */
export function topToReach(place, { top, height, row }) {
  return Math.max(0, Math.min(place * row, Math.max(top, (place + 1) * row - height)));
}

/** How far to scroll for a row to be in the middle. @param {number} place @param {Sight} sight */
export function topToCentre(place, { height, row }) {
  return Math.max(0, (place + 0.5) * row - height / 2);
}

/** The number of whole rows that are seen at once. @param {Sight} sight */
export function page({ height, row }) {
  return Math.max(1, Math.floor(height / row) - 1);
}

/** The first row of which all is in sight. @param {Sight} sight */
export function firstInSight({ top, row, rows }) {
  return Math.max(0, Math.min(rows - 1, Math.ceil(top / row)));
}
