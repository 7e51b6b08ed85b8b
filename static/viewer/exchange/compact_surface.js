import { welded } from "./welded.js";

/**
 * A surface without what can be found again: corners that stand at one place are one point, what is the same all over a flat
 * face is there once. Numbers that follow each other are near each other, so that they deflate well.
 *
 * @typedef {import("../geometry/records.js").Surface} Surface
 *
 * @typedef {object} Compact
 * @property {Surface["mode"]} mode
 * @property {Float32Array} points 3 each
 * @property {Int32Array} corners the point of each vertex, as the step from the one before
 * @property {Uint32Array | null} quads
 * @property {Int16Array} normals 3 of each face, or of each vertex where there are quads
 * @property {Int32Array} cells 1 of each face, or of each vertex, as the step from the one before
 * @property {Uint8Array} inside 1 of each face, or of each vertex
 * @property {Uint32Array} faces
 * @property {Int32Array} edges two points each, as steps
 * @property {Uint8Array} edge_cells
 * @property {Uint32Array} edge_faces
 */

/** Vertices of a flat face. */
const FLAT = 4;

/** @param {Surface} surface @returns {Compact} */
export function compact(surface) {
  const { mode, positions, normals, cells, inside, quads, faces, edges, edge_cells, edge_faces } = surface;
  const every = quads ? 1 : FLAT;
  const all = new Float32Array(positions.length + edges.length);
  all.set(positions);
  all.set(edges, positions.length);
  const { ids, firsts } = welded(all);
  const count = cells.length / every;
  const points = new Float32Array(3 * firsts.length);
  firsts.forEach((corner, k) => points.set(all.subarray(3 * corner, 3 * corner + 3), 3 * k));
  const flat = new Int16Array(3 * count);
  for (let k = 0; k < count; k++) flat.set(normals.subarray(4 * every * k, 4 * every * k + 3), 3 * k);
  return {
    mode,
    points,
    corners: steps(ids.subarray(0, positions.length / 3)),
    quads,
    normals: flat,
    cells: steps(cells.filter((_, k) => k % every === 0)),
    inside: inside.filter((_, k) => k % every === 0),
    faces,
    edges: steps(ids.subarray(positions.length / 3)),
    edge_cells,
    edge_faces,
  };
}

/** @param {Compact} record @returns {Surface} */
export function expanded({
  mode,
  points,
  corners,
  quads,
  normals,
  cells,
  inside,
  faces,
  edges,
  edge_cells,
  edge_faces,
}) {
  const every = quads ? 1 : FLAT;
  const count = corners.length;
  const positions = placed(summed(corners), points);
  const outward = new Int16Array(4 * count);
  const [all, side] = [new Uint32Array(count), new Uint8Array(count)];
  const own = summed(cells);
  for (let vertex = 0; vertex < count; vertex++) {
    const face = Math.floor(vertex / every);
    outward.set(normals.subarray(3 * face, 3 * face + 3), 4 * vertex);
    all[vertex] = own[face];
    side[vertex] = inside[face];
  }
  return {
    mode,
    positions,
    normals: outward,
    cells: all,
    inside: side,
    quads,
    faces,
    edges: placed(summed(edges), points),
    edge_cells,
    edge_faces,
  };
}

/** @param {Uint32Array} ids @param {Float32Array} points */
function placed(ids, points) {
  const out = new Float32Array(3 * ids.length);
  ids.forEach((id, k) => {
    for (let axis = 0; axis < 3; axis++) out[3 * k + axis] = points[3 * id + axis];
  });
  return out;
}

/** Each number less the one before. @param {Uint32Array} numbers */
function steps(numbers) {
  return Int32Array.from(numbers, (number, k) => number - (k ? numbers[k - 1] : 0));
}

/** @param {Int32Array} numbers */
function summed(numbers) {
  let sum = 0;
  return Uint32Array.from(numbers, (step) => (sum += step));
}
