import { isTriangle } from "../geometry/triangle.js";

/**
 * The shown surface as files of geometry have it: corners of faces with their colours, light and all.
 *
 * @typedef {object} ShownSurface
 * @property {Float32Array} points 3 per corner, in drawing coordinates
 * @property {Int16Array} normals 4 per corner, signed normalised
 * @property {Uint32Array} quads 4 corners per face; a triangle repeats its last
 * @property {Uint8Array} colours 3 per corner, sRGB
 * @property {Float32Array} edges 6 per line, in drawing coordinates
 * @property {Place} place
 * @property {string} name of the mesh
 * @property {string} reference where the mesh is from, in one line; may be empty
 *
 * @typedef {object} Place  where drawing coordinates are in the file's
 * @property {readonly number[]} centre
 * @property {number} diagonal
 * @property {readonly number[]} up what stands upright
 *
 * @typedef {object} Parts
 * @property {import("../geometry/records.js").Surface} surface
 * @property {(cell: number, inside: number) => readonly [number, number, number]} colourOf
 * @property {Float32Array | null} openness of each vertex to light, 0 to 1; null: no light
 * @property {number} shade strength of the light's shade, 0 to 1
 */

/** @param {Parts} parts @param {Pick<ShownSurface, "place" | "name" | "reference">} about @returns {ShownSurface} */
export function shownSurface({ surface, colourOf, openness, shade }, about) {
  const { positions, normals, cells, inside, edges } = surface;
  const colours = new Uint8Array(positions.length);
  for (let vertex = 0; vertex < cells.length; vertex++) {
    const colour = colourOf(cells[vertex], inside[vertex] / 255);
    const light = openness ? 1 + shade * (openness[vertex] - 1) : 1;
    for (let k = 0; k < 3; k++) colours[3 * vertex + k] = Math.round(light * colour[k]);
  }
  return { points: positions, normals, quads: quadsOf(surface, openness), colours, edges, ...about };
}

/**
 * Four corners of each face. Light is brought by corners and runs straight over each of two triangles: a face is cut along the
 * diagonal whose ends are more alike in light, where it looks least like a cut.
 *
 * @param {import("../geometry/records.js").Surface} surface @param {Float32Array | null} openness
 */
function quadsOf({ quads, faces, positions }, openness) {
  if (quads) return quads;
  const out = new Uint32Array(4 * faces.length);
  for (let k = 0; k < out.length; k += 4) {
    const turned = openness && !isTriangle(positions, 3 * k) && cutsOtherwise(openness, k) ? 1 : 0;
    for (let n = 0; n < 4; n++) out[k + n] = k + ((n + turned) & 3);
  }
  return out;
}

/** @param {Float32Array} openness @param {number} first */
function cutsOtherwise(openness, first) {
  const [a, b, c, d] = openness.subarray(first, first + 4);
  return Math.abs(b - d) < Math.abs(a - c);
}

/** The two triangles of each face, one of a triangle. @param {Uint32Array} quads @param {Float32Array} points @returns {Uint32Array} */
export function trianglesOf(quads, points) {
  const out = new Uint32Array((quads.length / 4) * 6);
  let to = 0;
  for (let k = 0; k < quads.length; k += 4) {
    const [a, b, c, d] = quads.subarray(k, k + 4);
    to = put(out, to, [a, b, c]);
    if (!same(points, c, d)) to = put(out, to, [a, c, d]);
  }
  return out.subarray(0, to);
}

/** @param {Uint32Array} out @param {number} to @param {readonly number[]} corners */
function put(out, to, corners) {
  out.set(corners, to);
  return to + 3;
}

/** Whether two corners stand at one place. @param {Float32Array} points @param {number} a @param {number} b */
export function same(points, a, b) {
  return [0, 1, 2].every((axis) => points[3 * a + axis] === points[3 * b + axis]);
}

/** A point in the file's coordinates. @param {ShownSurface} surface @param {number} corner @returns {[number, number, number]} */
export function pointOf({ points, place: { centre, diagonal } }, corner) {
  const at = (/** @type {number} */ axis) => points[3 * corner + axis] * diagonal + centre[axis];
  return [at(0), at(1), at(2)];
}
