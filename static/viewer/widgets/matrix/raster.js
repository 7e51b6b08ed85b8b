/**
 * What each pixel shows: nothing, the diagonal, or what a pair does (`CROSSES`, `BESIDE`, both) above DIAGONAL. Of several cells
 * on one pixel the highest is shown: of rare ones none is lost.
 *
 * @typedef {import("./pair_index.js").PairIndex} PairIndex @typedef {import("./window.js").Window} Window
 */
export const NOTHING = 0;
export const DIAGONAL = 1;

/** From so many pixels on cells stand apart. */
const APART = 6;

/**
 * The pixels that things in sight take on a line: each has one at least.
 *
 * @param {number} start of the window @param {number} size of it @param {number} count of things
 * @param {number} pixels along the line
 */
export function spans(start, size, count, pixels) {
  const scale = pixels / size;
  const gap = scale >= APART ? 1 : 0;
  const first = Math.max(0, Math.floor(start));
  const end = Math.min(count, Math.ceil(start + size));
  const [from, to] = [new Int32Array(end - first), new Int32Array(end - first)];
  for (let k = 0; k < end - first; k++) {
    const left = Math.floor((first + k - start) * scale);
    const right = Math.floor((first + k + 1 - start) * scale) - gap;
    from[k] = Math.max(0, left);
    to[k] = Math.min(pixels, Math.max(left + 1, right));
  }
  return { first, end, from, to };
}

/**
 * Draw the pairs in sight, and the diagonal. Only these are looked at.
 *
 * @param {PairIndex} index @param {Window} window @param {number} pixels along a side
 * @param {Uint8Array} [out] (pixels * pixels), row by row, to be written anew
 */
export function raster(index, { x, y, size }, pixels, out = new Uint8Array(pixels * pixels)) {
  const { starts, columns, kinds, count } = index;
  out.fill(NOTHING);
  const [across, down] = [spans(x, size, count, pixels), spans(y, size, count, pixels)];
  for (let row = down.first; row < down.end; row++) {
    const [top, bottom] = [down.from[row - down.first], down.to[row - down.first]];
    if (top >= bottom) continue;
    const line = out.subarray(top * pixels, (top + 1) * pixels);
    if (row >= across.first && row < across.end) draw(line, across, row, DIAGONAL);
    for (let cell = index.cellFrom(row, across.first); cell < starts[row + 1]; cell++) {
      if (columns[cell] >= across.end) break;
      draw(line, across, columns[cell], DIAGONAL + kinds[cell]);
    }
    for (let below = top + 1; below < bottom; below++) out.set(line, below * pixels);
  }
  return out;
}

/** @param {Uint8Array} line @param {ReturnType<typeof spans>} across @param {number} column @param {number} value */
function draw(line, { first, from, to }, column, value) {
  const end = to[column - first];
  for (let at = from[column - first]; at < end; at++) if (line[at] < value) line[at] = value;
}
