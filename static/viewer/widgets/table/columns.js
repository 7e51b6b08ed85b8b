import { count, decimal } from "../../state/numbers.js";

/**
 * @typedef {object} Column  one property of all rows
 * @property {string} id
 * @property {string} name in the head
 * @property {string} [hint] more about it, as a tooltip
 * @property {"number" | "word" | "flag"} kind
 * @property {ArrayLike<number | boolean>} values a number for each row; of words their places in `words`; of flags whether it holds
 * @property {readonly string[]} [words]
 * @property {(value: number) => string} [format] of numbers
 */

/** So many values, evenly spread, stand for all when the width of a column is looked for. */
const SAMPLE = 64;

/** Of so many texts the widest is looked for on the screen: the longest in letters need not be it. */
const CANDIDATES = 3;

/** @param {number} value */
const written = (value) => (Number.isInteger(value) ? count(value) : decimal(value));

/** What a cell says, by the column's kind; a flag says "yes" or nothing. @type {Record<Column["kind"], (column: Column, value: number) => string>} */
const TEXTS = {
  number: ({ format = written }, value) => format(value),
  word: ({ words = [] }, value) => words[value] ?? "",
  flag: (_, value) => (value ? "yes" : ""),
};

/** What a column says of a row. @param {Column} column @param {number} row */
export function textOf(column, row) {
  return TEXTS[column.kind](column, Number(column.values[row]));
}

/** Values whose texts may be the widest, by the column's kind. @type {Record<Column["kind"], (column: Column, rows: number) => Iterable<number>>} */
const WIDE = {
  number: ({ values }, rows) => [...extremes(values, rows), ...sample(values, rows)],
  word: ({ words = [] }) => words.keys(),
  flag: () => [],
};

/** The texts by which a column's width is measured: a few of the longest. @param {Column} column @param {number} rows */
export function widestTexts(column, rows) {
  const texts = new Set(
    Array.from(WIDE[column.kind](column, rows), (value) => TEXTS[column.kind](column, value)),
  );
  return [...texts].sort((a, b) => b.length - a.length).slice(0, CANDIDATES);
}

/** @param {Column["values"]} values @param {number} rows */
function extremes(values, rows) {
  let [low, high] = [Infinity, -Infinity];
  for (let row = 0; row < rows; row++) {
    const value = Number(values[row]);
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return low <= high ? [low, high] : [];
}

/** @param {Column["values"]} values @param {number} rows */
function sample(values, rows) {
  const some = Math.min(rows, SAMPLE);
  return Array.from({ length: some }, (_, k) => Number(values[Math.floor((k * rows) / some)]));
}
