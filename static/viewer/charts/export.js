import { titled } from "../state/units.js";

/**
 * The histogram's numbers as a file (SPEC Q4).
 *
 * @typedef {import("./histogram_layout.js").HistogramData} HistogramData
 */

/** One row per bin: lower edge, upper edge, count; the head names what was measured. @param {HistogramData} data @param {string} quantity @param {string} [unit] of its values @returns {string} */
export function toCsv(data, quantity, unit = "") {
  const rows = Array.from(data.counts, (count, bin) => `${data.edges[bin]},${data.edges[bin + 1]},${count}`);
  const name = quantity.replaceAll(/[",]/g, " ");
  return [`${titled(`${name} low`, unit)},${titled(`${name} high`, unit)},cells`, ...rows, ""].join("\r\n");
}
