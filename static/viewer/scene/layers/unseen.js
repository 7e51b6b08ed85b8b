/**
 * A surface of one face that stands behind an eye at the origin, which looks along -z.
 *
 * @type {import("../../geometry/records.js").Surface}
 */
export const UNSEEN = {
  mode: "lines",
  positions: new Float32Array([0, 0, 9, 1, 0, 9, 1, 1, 9, 0, 1, 9]),
  normals: Int16Array.from({ length: 16 }, (_, k) => (k % 4 === 2 ? 32767 : 0)),
  cells: new Uint32Array(4),
  inside: new Uint8Array(4),
  quads: null,
  faces: new Uint32Array(1),
  edges: new Float32Array([0, 0, 9, 1, 0, 9]),
  edge_cells: new Uint8Array(0),
  edge_faces: new Uint32Array(2),
};
