import { comparedOf } from "./tables.js";

/**
 * Two meshes beside each other: their numbers as a file, and what of the settings comes from the comparison.
 *
 * @typedef {import("./status.js").Status} Status
 * @typedef {import("./tables.js").MetricRow} MetricRow
 * @typedef {Readonly<Record<string, import("./answers.js").Statistics>>} Known  statistics by metric
 */

/** What of each metric is told. */
const COLUMNS = /** @type {const} */ (["min", "mean", "max"]);

/** A row for each metric that was measured of both. @param {readonly MetricRow[]} metrics @param {Known} a @param {Known} b */
export function tableCsv(metrics, a, b) {
  const head = ["metric", "better", ...COLUMNS.flatMap((name) => [`${name} A`, `${name} B`, `${name} B-A`])];
  const rows = metrics
    .filter(({ id }) => a[id] && b[id])
    .map(({ id, better }) => [
      id,
      better,
      ...COLUMNS.flatMap((name) => {
        const [ours, theirs] = [a[id][name], b[id][name]];
        return [ours ?? "", theirs ?? "", ours === null || theirs === null ? "" : theirs - ours];
      }),
    ]);
  return [head, ...rows, []].map((row) => row.join(",")).join("\r\n");
}

/**
 * What makes settings those of one mesh: the other's name, cells that were picked of it, and what shows quantities of the
 * comparison.
 *
 * @param {Status} status @param {Status} defaults @param {Pick<import("./tables.js").Tables, "compared">} tables
 * @returns {import("./status.js").PartialStatus}
 */
export function withoutComparison({ colour, arrows, filters }, { compare, colour: plain }, tables) {
  const ofBoth = (/** @type {string} */ quantity) => comparedOf(tables, quantity) !== undefined;
  return {
    compare: {
      other: compare.other,
      picking: compare.picking,
      reference: { shown: compare.reference.shown },
    },
    ...(colour.by === "attribute" && ofBoth(colour.attribute)
      ? { colour: { by: "quality", attribute: "", range: null, map: plain.map } }
      : {}),
    ...(ofBoth(arrows.attribute) ? { arrows: { attribute: "" } } : {}),
    filters: { quality: { items: filters.quality.items.filter(({ quantity }) => !ofBoth(quantity)) } },
  };
}
