import { VERTEX_COLUMNS, vertexRows, vertexTexel } from "../geometry/texel.js";
import { isTriangle } from "../geometry/triangle.js";

/** How far the point where a flat face's corner gathers light is drawn from the corner to the face's middle. */
export const PULL = 0.15;

/**
 * Where and facing what each drawn vertex gathers light: for the GPU, four words per vertex (three floats and a normal of two
 * 16-bit numbers, of whose last two bits the class of a rounded surface's vertex takes the place).
 *
 * A corner of a flat face stands on edges that other faces share, where openness has no one value: it is taken a little
 * inside the face, where it has: towards the middle of the diagonal that the face is cut at, so that it stays on the surface
 * where the face is not plane. A smooth vertex gathers light where it stands.
 *
 * @param {import("../geometry/records.js").Surface} surface
 * @param {import("./plates.js").Plates | null} plates of a rounded surface: where its vertices gather, and what share
 * @returns {{ words: Uint32Array, rows: number, box: Float64Array }} box: extent
 */
export function gatheringPoints(surface, plates) {
  const { positions, normals, quads } = surface;
  const vertices = positions.length / 3;
  const rows = vertexRows(vertices);
  const words = new Uint32Array(rows * VERTEX_COLUMNS * 4);
  const floats = new Float32Array(words.buffer);
  const flat = quads === null;
  const box = new Float64Array([Infinity, Infinity, Infinity, -Infinity, -Infinity, -Infinity]);
  let triangle = false;
  for (let v = 0, p = 0; v < vertices; v++) {
    const at = 4 * vertexTexel(v);
    const base = flat ? 12 * (v >> 2) : 0;
    if (flat && (v & 3) === 0) triangle = isTriangle(positions, base);
    for (let k = 0; k < 3; k++, p++) {
      const value = positions[p];
      if (value < box[k]) box[k] = value;
      if (value > box[k + 3]) box[k + 3] = value;
      if (flat) {
        const middle = triangle
          ? (positions[base + k] + positions[base + k + 3] + positions[base + k + 6]) / 3
          : (positions[base + k] + positions[base + k + 6]) / 2;
        floats[at + k] = value + PULL * (middle - value);
      } else floats[at + k] = plates ? positions[3 * plates.stands[v] + k] : value;
    }
    const n = 4 * (plates ? plates.stands[v] : v);
    const word = packNormal(normals[n], normals[n + 1], normals[n + 2]);
    words[at + 3] = (word & ~3) | (plates ? plates.classes[v] : 0);
  }
  return { words, rows, box };
}

/**
 * A direction in 32 bits: the octahedral mapping (Cigolle et al. 2014), as GLSL's unpackSnorm2x16 takes it.
 *
 * @param {number} x @param {number} y @param {number} z any length but 0
 * @returns {number}
 */
export function packNormal(x, y, z) {
  const sum = Math.abs(x) + Math.abs(y) + Math.abs(z) || 1;
  let u = x / sum;
  let v = y / sum;
  if (z < 0) {
    const w = (1 - Math.abs(v)) * (u < 0 ? -1 : 1);
    v = (1 - Math.abs(u)) * (v < 0 ? -1 : 1);
    u = w;
  }
  return ((Math.round(u * 32767) & 0xffff) | (Math.round(v * 32767) << 16)) >>> 0;
}
