/**
 * What a vertex of a rounded surface gathers, in comparison with the open side of its cell. The grooves between rounded cells
 * are alike whatever their size, so that ray tracing one tells them all: `tests/browser/scene/test_openness.py` holds this
 * against ray-traced meshes.
 */
export const GROOVE_SHARES = [1, 0.93, 0.27, 0];

const OPEN = 0;
const RIM = 1;
const GROOVE = 2;
const CLOSED = 3;

/** From a corner of a rounded face to where the cell's corner was, over the distance to the flat part: closes the grooves. */
const REACH = 0.75;

/**
 * @typedef {object} Plates
 * @property {Float32Array} corners (12 F) four corners of a plate for each face that is whole
 * @property {Uint8Array} classes (N) row of `GROOVE_SHARES` for each vertex of the surface
 * @property {Uint32Array} stands (N) vertex in whose place each vertex gathers
 * @property {number} rounding mean distance from a rounded corner to its face's flat part
 */

/**
 * A rounded surface as light sees it from afar: a plate for each face that shows, in place of the nine quads and the walls of
 * the grooves round it, which are far smaller than a depth map's pixel and would take most of the time. What the grooves keep
 * off is then a fixed share by place.
 *
 * A whole face of n corners is a run of quads of one tag: at each corner a quad that begins with the corner's tip and has the
 * flat part's corner third, followed by a strip, and last the flat part. Runs of other make are walls of grooves.
 *
 * @param {import("../geometry/records.js").Surface} surface in rounded mode
 * @returns {Plates}
 */
export function platesOf({ positions, quads, faces }) {
  const ids = /** @type {Uint32Array} */ (quads);
  const vertices = positions.length / 3;
  const classes = new Uint8Array(vertices).fill(CLOSED);
  const stands = Uint32Array.from({ length: vertices }, (_, k) => k);
  const corners = new Float32Array(12 * faces.length);
  const tips = new Uint8Array(vertices);
  /** @type {number[]} */
  const walls = [];
  let plates = 0;
  let rounding = 0;
  for (let begin = 0, end = 0; begin < faces.length; begin = end) {
    let thin = 0;
    for (end = begin; end < faces.length && faces[end] === faces[begin]; end++) {
      if (ids[4 * end + 2] === ids[4 * end + 3]) thin++;
    }
    const length = end - begin;
    const sides = length === 9 && thin === 0 ? 4 : length === 7 && thin === 1 ? 3 : 0;
    if (sides === 0) {
      walls.push(begin, end);
      continue;
    }
    rounding += plate(positions, ids, begin, sides, corners, 12 * plates++);
    for (let k = 0; k < sides; k++) {
      const at = 4 * (begin + 2 * k);
      for (const place of [0, 1, 3]) classes[ids[at + place]] = Math.min(classes[ids[at + place]], RIM);
      classes[ids[at + 2]] = OPEN;
      tips[ids[at]] = 1;
    }
  }
  for (let k = 0; k < walls.length; k += 2) {
    for (let q = walls[k]; q < walls[k + 1]; q++) if (tips[ids[4 * q]]) wall(ids, q, classes, stands);
  }
  return {
    corners: corners.subarray(0, 12 * plates),
    classes,
    stands,
    rounding: plates > 0 ? rounding / plates : 0,
  };
}

/**
 * A quad of a groove's wall: those of its vertices that begin to dive, beside the tip of a whole face, see what the tip sees,
 * less.
 *
 * @param {Uint32Array} ids
 * @param {number} quad
 * @param {Uint8Array} classes
 * @param {Uint32Array} stands
 */
function wall(ids, quad, classes, stands) {
  const tip = ids[4 * quad];
  for (const place of [1, 3]) {
    const vertex = ids[4 * quad + place];
    if (classes[vertex] <= RIM) continue;
    classes[vertex] = GROOVE;
    stands[vertex] = tip;
  }
}

/**
 * Writes the plate of a whole face.
 *
 * @param {Float32Array} positions
 * @param {Uint32Array} ids
 * @param {number} begin first quad of the face's run
 * @param {number} sides 3 or 4
 * @param {Float32Array} corners
 * @param {number} at
 * @returns {number} distance from the first tip to the flat part
 */
function plate(positions, ids, begin, sides, corners, at) {
  const middle = [0, 0, 0];
  for (let k = 0; k < sides; k++) {
    const tip = 3 * ids[4 * (begin + 2 * k)];
    for (let c = 0; c < 3; c++) middle[c] += positions[tip + c] / sides;
  }
  let first = 0;
  for (let k = 0; k < 4; k++) {
    const quad = 4 * (begin + 2 * Math.min(k, sides - 1));
    const tip = 3 * ids[quad];
    const flat = 3 * ids[quad + 2];
    const out = [0, 1, 2].map((c) => positions[tip + c] - middle[c]);
    const step = Math.hypot(...[0, 1, 2].map((c) => positions[tip + c] - positions[flat + c]));
    const scale = 1 + (REACH * step) / (Math.hypot(...out) || 1);
    for (let c = 0; c < 3; c++) corners[at + 3 * k + c] = middle[c] + scale * out[c];
    if (k === 0) first = step;
  }
  return first;
}
