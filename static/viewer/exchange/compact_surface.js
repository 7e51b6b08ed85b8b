import { steps, summed } from "./steps.js";
import { pointsAt, sharedPoints } from "./welded.js";

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
 * @property {Int16Array} normals 3 of each vertex where there are quads; of flat faces those that their corners don't tell
 * @property {Int32Array} turned flat faces whose normals these are, as steps
 * @property {Int32Array} cells 1 of each face, or of each vertex, as the step from the one before
 * @property {Uint8Array} inside 1 of each face, or of each vertex
 * @property {Int32Array} faces as steps
 * @property {Int32Array} edges two points each, as steps
 * @property {Uint8Array} edge_cells
 * @property {Uint32Array} edge_faces
 * @property {boolean} two_sided
 */

/** Vertices of a flat face. */
const FLAT = 4;

/** By so much, of 32767, a normal may be another for having been rounded. */
const ROUNDING = 4;

/** @param {Surface} surface @returns {Compact} */
export function compact(surface) {
  const { mode, positions, normals, cells, inside, quads, faces, edges, edge_cells, edge_faces, two_sided } =
    surface;
  const every = quads ? 1 : FLAT;
  const { ids, points } = sharedPoints(positions, edges);
  const { told, turned } = quads ? { told: everyNormal(normals), turned: [] } : untold(normals, positions);
  return {
    mode,
    points,
    corners: steps(ids.subarray(0, positions.length / 3)),
    quads,
    normals: Int16Array.from(told),
    turned: steps(Uint32Array.from(turned)),
    cells: steps(cells.filter((_, k) => k % every === 0)),
    inside: inside.filter((_, k) => k % every === 0),
    faces: steps(faces),
    edges: steps(ids.subarray(positions.length / 3)),
    edge_cells,
    edge_faces,
    two_sided,
  };
}

/** @param {Compact} record @returns {Surface} */
export function expanded(record) {
  const { mode, points, quads, inside, edge_cells, edge_faces, two_sided } = record;
  const every = quads ? 1 : FLAT;
  const positions = pointsAt(summed(record.corners), points);
  const count = positions.length / 3;
  const [cells, side] = [new Uint32Array(count), new Uint8Array(count)];
  const own = summed(record.cells);
  for (let vertex = 0; vertex < count; vertex++) {
    const face = Math.floor(vertex / every);
    cells[vertex] = own[face];
    side[vertex] = inside[face];
  }
  return {
    mode,
    positions,
    normals: quads ? fourfold(record.normals, 1) : flatNormals(positions, record),
    cells,
    inside: side,
    quads,
    faces: summed(record.faces),
    edges: pointsAt(summed(record.edges), points),
    edge_cells,
    edge_faces,
    two_sided,
  };
}

/** @param {Int16Array} normals 4 each @returns {number[]} 3 each */
function everyNormal(normals) {
  return [...normals.filter((_, k) => k % 4 !== 3)];
}

/**
 * Normals of flat faces that are not those of their diagonals, as of faces without area.
 *
 * @param {Int16Array} normals @param {Float32Array} positions
 */
function untold(normals, positions) {
  /** @type {{ told: number[], turned: number[] }} */
  const found = { told: [], turned: [] };
  for (let face = 0; face < positions.length / 12; face++) {
    const own = normals.subarray(16 * face, 16 * face + 3);
    const guess = diagonalNormal(positions, 12 * face);
    if (own.every((part, k) => Math.abs(part - guess[k]) <= ROUNDING)) continue;
    found.told.push(...own);
    found.turned.push(face);
  }
  return found;
}

/** @param {Float32Array} positions @param {Pick<Compact, "normals" | "turned">} record */
function flatNormals(positions, { normals, turned }) {
  const each = new Int16Array(positions.length / 4);
  for (let face = 0; face < each.length / 3; face++) each.set(diagonalNormal(positions, 12 * face), 3 * face);
  summed(turned).forEach((face, k) => each.set(normals.subarray(3 * k, 3 * k + 3), 3 * face));
  return fourfold(each, FLAT);
}

/** The cross of a face's diagonals, as the core has it (`hexalab.surface.normals`). @param {Float32Array} positions @param {number} at @returns {[number, number, number]} */
function diagonalNormal(positions, at) {
  const [a, b] = [6, 9].map((to, k) =>
    [0, 1, 2].map((axis) => positions[at + to + axis] - positions[at + 3 * k + axis]),
  );
  const cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const length = Math.hypot(...cross) || 1;
  const part = (/** @type {number} */ axis) => Math.round((32767 * cross[axis]) / length);
  return [part(0), part(1), part(2)];
}

/** Normals with their spare fourth number, each so often. @param {Int16Array} normals 3 each @param {number} often */
function fourfold(normals, often) {
  const out = new Int16Array((normals.length / 3) * 4 * often);
  for (let k = 0; k < out.length / 4; k++)
    out.set(normals.subarray(3 * Math.floor(k / often), 3 * Math.floor(k / often) + 3), 4 * k);
  return out;
}
