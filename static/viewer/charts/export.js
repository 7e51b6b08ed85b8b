import { titled } from "../state/units.js";

/**
 * The histogram's numbers as a file (SPEC Q4).
 *
 * @typedef {import("./histogram_layout.js").HistogramData} HistogramData
 */

/**
 * One row per bin: lower edge, upper edge, count; the head names what was measured. Of a second mesh the count, and the edges
 * where they are others.
 *
 * @param {HistogramData} data @param {string} quantity @param {string} [unit] of its values
 * @param {import("./steps.js").Counted | null} [second] of a second mesh, in as many bins
 * @returns {string}
 */
export function toCsv(data, quantity, unit = "", second = null) {
  const name = quantity.replaceAll(/[",]/g, " ");
  const ends = ["low", "high"].map((end) => titled(`${name} ${end}`, unit));
  const columns = (
    /** @type {import("./steps.js").Counted} */ { edges, counts },
    /** @type {number} */ bin,
  ) => [edges[bin], edges[bin + 1], counts[bin]];
  const apart = second && Array.from(data.edges).some((edge, k) => edge !== second.edges[k]);
  const head = [
    ...(apart ? ends.map((end) => `${end} of A`) : ends),
    second ? "cells of A" : "cells",
    ...(apart ? ends.map((end) => `${end} of B`) : []),
    ...(second ? ["cells of B"] : []),
  ];
  const rows = Array.from(data.counts, (_, bin) => [
    ...columns(data, bin),
    ...(second ? columns(second, bin).slice(apart ? 0 : -1) : []),
  ]);
  return [head, ...rows, []].map((row) => row.join(",")).join("\r\n");
}
