/**
 * The histogram's numbers as a file (SPEC Q4).
 *
 * @typedef {import("./histogram_layout.js").HistogramData} HistogramData
 */

/** One row per bin: lower edge, upper edge, count; the head names what was measured. @param {HistogramData} data @param {string} quantity @returns {string} */
export function toCsv(data, quantity) {
  const rows = Array.from(data.counts, (count, bin) => `${data.edges[bin]},${data.edges[bin + 1]},${count}`);
  const name = quantity.replaceAll(/[",]/g, " ");
  return [`${name} low,${name} high,cells`, ...rows, ""].join("\r\n");
}
