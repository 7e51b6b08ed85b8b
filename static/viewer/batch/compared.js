/**
 * What a batch tells of a mesh beside what it is compared with: as `hexalab compare --json` does, and as columns of the table.
 *
 * @typedef {import("./batch.js").Host} Host
 * @typedef {import("./batch.js").Numbers} Numbers
 * @typedef {import("./batch.js").Row} Row
 * @typedef {import("../state/answers.js").Changes} Changes
 * @typedef {import("../state/answers.js").DistanceFacts} DistanceFacts
 *
 * @typedef {object} Comparison
 * @property {string} with what it is compared with
 * @property {boolean} same_cells
 * @property {Readonly<Record<string, Numbers>>} difference by metric, of each of `DIFFERENCES` what the second has more; none for a surface
 * @property {Readonly<Record<string, Changes>> | null} changes by metric; null where the cells are others
 * @property {import("../state/facts.js").Apart} distance
 * @property {number | null} volume_ratio
 */

/** Statistics whose differences are told. */
const DIFFERENCES = /** @type {const} */ (["min", "mean", "max"]);

/** What is told of each way between the two surfaces. */
const DISTANCES = /** @type {const} */ (["max", "mean", "rms"]);

/** Counts of cells at which a metric changed. */
const CHANGED = /** @type {const} */ (["worse", "better"]);

/**
 * @param {Host} host @param {string} name of what it is compared with, in the table
 * @param {Readonly<Record<string, Numbers>>} quality of the mesh, by metric
 * @returns {Promise<Comparison>}
 * @throws {Error} it could not be compared, which was also said
 */
export async function comparisonOf({ facts, tables, comparing }, name, quality) {
  const told = facts.get("comparison");
  const distance = told && (await comparing.distances.measure());
  if (!distance) throw new Error(`it could not be compared with ${name}`);
  const { second } = comparing;
  /** @type {Record<string, Numbers>} */
  const difference = {};
  /** @type {Record<string, Changes>} */
  const changes = {};
  for (const { id } of tables.metrics) {
    if (second) difference[id] = differenceOf(quality[id], await second.client.call("quality", [id]));
    const changed = told.same_cells && (await comparing.changes(id));
    if (changed) changes[id] = changed;
  }
  const { same_cells, volume_ratio } = told;
  return {
    with: name,
    same_cells,
    difference,
    changes: same_cells ? changes : null,
    distance,
    volume_ratio,
  };
}

/** @param {Numbers} a @param {Readonly<Record<(typeof DIFFERENCES)[number], number | null>>} b @returns {Numbers} */
function differenceOf(a, b) {
  return Object.fromEntries(
    DIFFERENCES.map((name) => {
      const [ours, theirs] = [a[name], b[name]];
      return [name, typeof ours === "number" && typeof theirs === "number" ? theirs - ours : null];
    }),
  );
}

/** Its columns of the table. @param {Comparison} comparison @returns {Row} */
export function columnsOf({ with: name, same_cells, difference, changes, distance, volume_ratio }) {
  const ways = /** @type {const} */ (["a_to_b", "b_to_a"]).flatMap((way) =>
    DISTANCES.flatMap((what) => [
      [`distance_${way}_${what}`, distance[way][what]],
      [`distance_${way}_${what}_percent`, distance[way][`${what}_percent`]],
    ]),
  );
  const metrics = Object.keys({ ...difference, ...changes });
  return {
    with: name,
    same_cells: String(same_cells),
    hausdorff: distance.hausdorff,
    hausdorff_percent: distance.hausdorff_percent,
    ...Object.fromEntries(ways),
    volume_ratio: volume_ratio ?? "",
    ...Object.fromEntries(
      metrics.flatMap((id) => [
        ...Object.entries(difference[id] ?? {}).map(([what, value]) => [
          `${id}_difference_${what}`,
          value ?? "",
        ]),
        ...(changes?.[id] ? CHANGED.map((what) => [`${id}_${what}`, changes[id][what]]) : []),
      ]),
    ),
  };
}
