/**
 * Numbers of two meshes beside each other, as a file.
 *
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
