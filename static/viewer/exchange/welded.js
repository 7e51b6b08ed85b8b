/**
 * Makes one vertex of corners that stand at one place and have one colour.
 *
 * >  welded(points, colours).ids    [0, 1, 2, 3, 1, 4, 5, 2] of two faces that share an edge
 *
 * @param {Float32Array} points 3 per corner @param {Uint8Array} [colours] 3 per corner; corners of any colour weld without
 * @returns {{ ids: Uint32Array, firsts: Uint32Array }} the vertex of each corner, and a corner of each vertex
 */
export function welded(points, colours) {
  const count = points.length / 3;
  const bits = new Uint32Array(points.buffer, points.byteOffset, points.length);
  const ids = new Uint32Array(count);
  const firsts = new Uint32Array(count);
  let size = 1024;
  while (size < 2 * count) size *= 2;
  const table = new Int32Array(size).fill(-1);
  let vertices = 0;
  const colourOf = (/** @type {number} */ corner) =>
    colours ? (colours[3 * corner] << 16) | (colours[3 * corner + 1] << 8) | colours[3 * corner + 2] : 0;
  for (let corner = 0; corner < count; corner++) {
    const at = 3 * corner;
    const colour = colourOf(corner);
    let slot = hash(bits[at], bits[at + 1], bits[at + 2], colour) & (size - 1);
    for (;;) {
      const vertex = table[slot];
      if (vertex < 0) {
        table[slot] = vertices;
        firsts[vertices] = corner;
        ids[corner] = vertices++;
        break;
      }
      const other = firsts[vertex];
      const alike =
        points[3 * other] === points[at] &&
        points[3 * other + 1] === points[at + 1] &&
        points[3 * other + 2] === points[at + 2];
      if (alike && colourOf(other) === colour) {
        ids[corner] = vertex;
        break;
      }
      slot = (slot + 1) & (size - 1);
    }
  }
  return { ids, firsts: firsts.slice(0, vertices) };
}

/**
 * The points that corners share, each once.
 *
 * @param {...Float32Array} lists of corners, 3 numbers each, one after the other
 * @returns {{ ids: Uint32Array, points: Float32Array }} the point of each corner of all lists, and the points
 */
export function sharedPoints(...lists) {
  const all = new Float32Array(lists.reduce((total, { length }) => total + length, 0));
  let at = 0;
  for (const list of lists) {
    all.set(list, at);
    at += list.length;
  }
  const { ids, firsts } = welded(all);
  return { ids, points: pointsAt(firsts, all) };
}

/** @param {Uint32Array} ids @param {Float32Array} points 3 numbers each @returns {Float32Array} those points, one after the other */
export function pointsAt(ids, points) {
  const out = new Float32Array(3 * ids.length);
  ids.forEach((id, k) => {
    for (let axis = 0; axis < 3; axis++) out[3 * k + axis] = points[3 * id + axis];
  });
  return out;
}

/** Of a point's bits (two zeros alike) and its colour: FNV-1a over words, its high bits brought down. @param {readonly number[]} words */
function hash(...words) {
  let sum = 0x811c9dc5;
  for (const word of words) sum = Math.imul(sum ^ (word === 0x80000000 ? 0 : word), 0x01000193);
  return (sum ^ (sum >>> 15)) >>> 0;
}
