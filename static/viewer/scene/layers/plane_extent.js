import { frameOf } from "../frame_of.js";

/**
 * Extent of the mesh's box along a direction, in drawing coordinates.
 *
 * @param {import("../../geometry/records.js").MeshFrame} mesh
 * @param {readonly number[]} normal any length but 0
 * @returns {[number, number]}
 */
export function planeExtent(mesh, normal) {
  const length = Math.hypot(...normal) || 1;
  const half = frameOf(mesh).high.reduce((sum, side, k) => sum + (Math.abs(normal[k]) / length) * side, 0);
  return [-half, half];
}
