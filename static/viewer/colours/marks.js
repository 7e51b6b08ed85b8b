/**
 * What is drawn over the surface: rows are the numbers that the core gives marks (`session/marked.py`). Six for groups, of Okabe
 * and Ito's set and darker where it is too light for lines; ink for what is in no group, grey where that is a face, which would
 * blacken the body; the signal colour for features that the mesh does not hold, which are broader too.
 */
export const MARK_STYLES = Object.freeze([
  { colour: "#0072b2", ink: 1 },
  { colour: "#d17a00", ink: 1 },
  { colour: "#00805d", ink: 1 },
  { colour: "#b0538c", ink: 1 },
  { colour: "#2e9ad6", ink: 1 },
  { colour: "#7a5c00", ink: 1 },
  { colour: "#1d1f23", film: "#8d949c", ink: 1 },
  { colour: "#c8372d", ink: 1, width: 1.8 },
]);

/** Row of features that the mesh does not hold. */
export const LOST = 7;

/** @param {number} row */
export function markColour(row) {
  return MARK_STYLES[Math.min(row, MARK_STYLES.length - 1)].colour;
}
