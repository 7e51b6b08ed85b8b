import { titled } from "../state/units.js";

/**
 * The histogram's numbers as a file (SPEC Q4).
 *
 * @typedef {import("./histogram_layout.js").HistogramData} HistogramData
 */

/**
 * One row per bin: lower edge, upper edge, count; the head names what was measured.
 *
 * @param {HistogramData} data @param {string} quantity @param {string} [unit] of its values
 * @param {ArrayLike<number> | null} [second] counts of a second mesh in the same bins
 * @returns {string}
 */
export function toCsv(data, quantity, unit = "", second = null) {
  const more = (/** @type {number} */ bin) => (second ? `,${second[bin]}` : "");
  const rows = Array.from(
    data.counts,
    (count, bin) => `${data.edges[bin]},${data.edges[bin + 1]},${count}${more(bin)}`,
  );
  const name = quantity.replaceAll(/[",]/g, " ");
  const head = `${titled(`${name} low`, unit)},${titled(`${name} high`, unit)},cells`;
  return [second ? `${head} of A,cells of B` : head, ...rows, ""].join("\r\n");
}
