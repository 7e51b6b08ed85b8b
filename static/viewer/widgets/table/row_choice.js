/**
 * @typedef {"one" | "toggle" | "extend" | "add" | "move"} Way  how a row is meant: it alone; with the others, or no longer; all rows
 *   from the last one that was meant without Shift; these beside the others; or none is chosen, the cursor moves alone
 */

/**
 * Rows that are chosen, and the row of the cursor, by their numbers: neither changes when the table is sorted.
 *
 *     choice.take(17, "one", order, places);
 *     choice.take(40, "extend", order, places);
 *     choice.ids; // all rows that stand between 17 and 40, as the table is sorted
 */
export class RowChoice {
  /** @type {Set<number>} */
  #rows = new Set();

  /** Where a range begins. @type {number | null} */
  #anchor = null;

  /** The row of the cursor. @type {number | null} */
  cursor = null;

  /** The chosen rows, in the order in which they were chosen. */
  get ids() {
    return [...this.#rows];
  }

  get size() {
    return this.#rows.size;
  }

  /** @param {number} row */
  has(row) {
    return this.#rows.has(row);
  }

  /**
   * Choose by hand.
   *
   * @param {number} row @param {Way} way
   * @param {Uint32Array} order row at each place @param {Uint32Array} places place of each row
   */
  take(row, way, order, places) {
    this.#rows = WAYS[way](this.#rows, row, () => rangeOf(this.#anchor ?? row, row, order, places));
    if (way === "one" || way === "toggle" || this.#anchor === null) this.#anchor = row;
    this.cursor = row;
  }

  /** Choose these rows and no others. @param {readonly number[]} ids @param {number | null} cursor */
  set(ids, cursor) {
    this.#rows = new Set(ids);
    this.#anchor = cursor;
    this.cursor = cursor;
  }

  /** Choose none; the cursor stays. */
  clear() {
    this.#rows = new Set();
  }

  /** Whether just these rows are chosen. @param {readonly number[]} ids */
  is(ids) {
    const wanted = new Set(ids);
    return wanted.size === this.#rows.size && ids.every((row) => this.#rows.has(row));
  }
}

/** What is chosen afterwards. @type {Record<Way, (rows: Set<number>, row: number, range: () => Iterable<number>) => Set<number>>} */
const WAYS = {
  one: (_, row) => new Set([row]),
  toggle: (rows, row) => (rows.has(row) ? without(rows, row) : new Set([...rows, row])),
  extend: (_rows, _row, range) => new Set(range()),
  add: (rows, _, range) => new Set([...rows, ...range()]),
  move: (rows) => rows,
};

/** @param {Set<number>} rows @param {number} row */
function without(rows, row) {
  const rest = new Set(rows);
  rest.delete(row);
  return rest;
}

/** The rows between two, these included. @param {number} from @param {number} to @param {Uint32Array} order @param {Uint32Array} places */
function rangeOf(from, to, order, places) {
  const [a, b] = [places[from], places[to]];
  return order.subarray(Math.min(a, b), Math.max(a, b) + 1);
}
