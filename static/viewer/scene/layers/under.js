import { INSIDE } from "./lines_layer.js";

/**
 * What lies under each edge of a surface that stands four by four: the cells of two faces beside it, and whether filters expose
 * these.
 *
 * @param {import("../../geometry/records.js").Surface} surface
 * @returns {Uint32Array} 2 for each edge
 */
export function under({ edge_faces, faces, inside }) {
  const sides = new Uint32Array(edge_faces.length);
  for (let k = 0; k < sides.length; k++) {
    const face = edge_faces[k];
    sides[k] = (faces[face] >>> 3) + (inside[4 * face] ? INSIDE : 0);
  }
  return sides;
}
