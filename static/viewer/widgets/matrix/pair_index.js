/**
 * @typedef {object} Pairs  of things, each pair once
 * @property {number} count of the things
 * @property {ArrayLike<number>} one
 * @property {ArrayLike<number>} other not below `one`; equal where a thing meets itself
 * @property {ArrayLike<number>} crossings how often they cross
 * @property {ArrayLike<number>} beside how often they run side by side
 *
 * @typedef {{ row: number, column: number }} Place
 */

/** What a pair does; both are their sum. */
export const CROSSES = 1;
export const BESIDE = 2;

/** Pairs as the rows of a symmetric matrix: sorted once, then a row, and a stretch of it, is found without looking at others. */
export class PairIndex {
  /** Where each row begins in `columns` and `pairs`; one more at the end. */
  starts;

  /** Of each cell its column, ascending in a row. */
  columns;

  /** Of each cell its pair. */
  pairs;

  /** Of each cell what its pair does: CROSSES, BESIDE, or both. */
  kinds;

  /** @param {Pairs} pairs */
  constructor({ count, one, other, crossings, beside }) {
    this.count = count;
    const cells = mirrored(one, other);
    const byColumn = byKey(null, cells.column, count);
    const { order, starts } = byKey(byColumn.order, cells.row, count);
    this.starts = starts;
    this.columns = taken(cells.column, order);
    this.pairs = taken(cells.pair, order);
    this.kinds = new Uint8Array(order.length);
    for (let cell = 0; cell < order.length; cell++) {
      const pair = this.pairs[cell];
      this.kinds[cell] = (crossings[pair] > 0 ? CROSSES : 0) | (beside[pair] > 0 ? BESIDE : 0);
    }
  }

  /** The first cell of a row whose column is not below one. @param {number} row @param {number} column */
  cellFrom(row, column) {
    let [low, high] = [this.starts[row], this.starts[row + 1]];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.columns[middle] < column) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  /** The pair at a place; -1 where there is none. @param {Place} place */
  pairAt({ row, column }) {
    const cell = this.cellFrom(row, column);
    return cell < this.starts[row + 1] && this.columns[cell] === column ? this.pairs[cell] : -1;
  }

  /** The column of the next pair in a row; the same column where there is none. @param {Place} place @param {1 | -1} step */
  nextInRow({ row, column }, step) {
    const cell = step > 0 ? this.cellFrom(row, column + 1) : this.cellFrom(row, column) - 1;
    return cell >= this.starts[row] && cell < this.starts[row + 1] ? this.columns[cell] : column;
  }

  /** The place of the pair nearest to one, no further away than `reach` in rows and columns. @param {Place} place @param {number} reach @returns {Place | null} */
  nearest({ row, column }, reach) {
    let [best, found] = [Infinity, /** @type {Place | null} */ (null)];
    for (let r = Math.max(0, row - reach); r <= Math.min(this.count - 1, row + reach); r++) {
      const from = this.cellFrom(r, column);
      for (const cell of [from - 1, from]) {
        if (cell < this.starts[r] || cell >= this.starts[r + 1]) continue;
        const distance = Math.max(Math.abs(r - row), Math.abs(this.columns[cell] - column));
        if (distance > reach || distance >= best) continue;
        [best, found] = [distance, { row: r, column: this.columns[cell] }];
      }
    }
    return found;
  }
}

/** Each pair on both sides of the diagonal, those on it once. @param {ArrayLike<number>} one @param {ArrayLike<number>} other */
function mirrored(one, other) {
  let twice = 0;
  for (let pair = 0; pair < one.length; pair++) if (one[pair] !== other[pair]) twice++;
  const cells = one.length + twice;
  const [row, column, pair] = [new Uint32Array(cells), new Uint32Array(cells), new Uint32Array(cells)];
  for (let k = 0, mirror = one.length; k < one.length; k++) {
    row[k] = one[k];
    column[k] = other[k];
    pair[k] = k;
    if (one[k] === other[k]) continue;
    row[mirror] = other[k];
    column[mirror] = one[k];
    pair[mirror++] = k;
  }
  return { row, column, pair };
}

/**
 * Cells sorted by a key below `count`, equal ones as they came: by counting, since there may be millions.
 *
 * @param {Uint32Array | null} cells as they come; null: one after the other
 * @param {Uint32Array} keys of the cells @param {number} count
 */
function byKey(cells, keys, count) {
  const starts = new Uint32Array(count + 1);
  for (let k = 0; k < keys.length; k++) starts[keys[k] + 1]++;
  for (let key = 0; key < count; key++) starts[key + 1] += starts[key];
  const next = starts.slice();
  const order = new Uint32Array(keys.length);
  for (let k = 0; k < keys.length; k++) {
    const cell = cells ? cells[k] : k;
    order[next[keys[cell]]++] = cell;
  }
  return { starts, order };
}

/** @param {Uint32Array} values @param {Uint32Array} order */
function taken(values, order) {
  const out = new Uint32Array(order.length);
  for (let k = 0; k < order.length; k++) out[k] = values[order[k]];
  return out;
}
