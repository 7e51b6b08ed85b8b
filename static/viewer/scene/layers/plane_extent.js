/**
 * Extent of the mesh's box along a direction, in drawing coordinates.
 *
 * @param {import("../types.js").MeshFrame} mesh
 * @param {readonly number[]} normal any length but 0
 * @returns {[number, number]}
 */
export function planeExtent({ extent, diagonal }, normal) {
  const length = Math.hypot(...normal) || 1;
  let half = 0;
  for (let k = 0; k < 3; k++) {
    const side = extent && diagonal ? (extent[1][k] - extent[0][k]) / diagonal : 1 / Math.sqrt(3);
    half += (Math.abs(normal[k] / length) * side) / 2;
  }
  return [-half, half];
}
