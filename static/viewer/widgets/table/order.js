/** @typedef {import("./columns.js").Column} Column */

/** The rows as they come. @param {number} rows */
export function unsorted(rows) {
  return Uint32Array.from({ length: rows }, (_, row) => row);
}

/**
 * The order of rows by a column. Rows that are equal in it stay as they were, in both directions, so that columns can be
 * sorted by one after the other; what is no number comes last, in both directions too.
 *
 * @param {Uint32Array} order rows, as they are ordered now
 * @param {Column} column
 * @param {boolean} descending
 * @returns {Uint32Array}
 */
export function sorted(order, column, descending) {
  const keys = keysOf(column, order.length);
  const some = order.filter((row) => !Number.isNaN(keys[row]));
  const others = some.length < order.length ? order.filter((row) => Number.isNaN(keys[row])) : [];
  some.sort(descending ? (a, b) => keys[b] - keys[a] : (a, b) => keys[a] - keys[b]);
  const out = new Uint32Array(order.length);
  out.set(some);
  out.set(others, some.length);
  return out;
}

/** Where each row stands in an order. @param {Uint32Array} order */
export function placesOf(order) {
  const places = new Uint32Array(order.length);
  order.forEach((row, place) => void (places[row] = place));
  return places;
}

/** A number for each row, by which it is sorted: of words their rank. @param {Column} column @param {number} rows */
function keysOf({ values, words }, rows) {
  const ranks = words && ranksOf(words);
  return Float64Array.from({ length: rows }, (_, row) => {
    const value = Number(values[row]);
    return ranks ? (ranks[value] ?? NaN) : value;
  });
}

/** The place of each word among all in the order of a dictionary, numbers in them by their size. @param {readonly string[]} words */
function ranksOf(words) {
  const { compare } = new Intl.Collator("en-GB", { numeric: true });
  const ranks = new Float64Array(words.length);
  [...words.keys()]
    .sort((a, b) => compare(words[a], words[b]))
    .forEach((word, rank) => void (ranks[word] = rank));
  return ranks;
}
