import { steps, summed } from "./steps.js";
import { pointsAt, sharedPoints } from "./welded.js";

/**
 * Irregular edges, barbs and flaps whose ends are points that they share; boundary ones only where they are drawn.
 *
 * @typedef {import("../geometry/records.js").Irregular} Irregular
 * @typedef {Omit<Irregular, "edges" | "barbs" | "paper"> & { points: Float32Array, ends: Int32Array, lengths: number[] }} CompactIrregular
 *   points: 3 each; ends: those of edges, barbs and flaps, as steps; lengths: how many ends these have
 */

const POINTS = /** @type {const} */ (["edges", "barbs", "paper"]);

/** Lists by what they tell of, and numbers of each: ends of points have three. */
const LISTS = /** @type {const} */ ({
  edges: { numbers: 6, beside: ["valence", "boundary", "ends_on_boundary"] },
  barbs: { numbers: 6, beside: ["barb_valence", "barb_boundary"] },
  paper: { numbers: 12, beside: ["paper_valence", "paper_boundary"] },
});

/** @param {Irregular | undefined} record @param {boolean} boundary whether boundary edges are drawn @returns {CompactIrregular | null} */
export function compactIrregular(record, boundary) {
  if (!record) return null;
  const kept = boundary ? record : interior(record);
  const { edges, barbs, paper, ...others } = kept;
  const { ids, points } = sharedPoints(edges, barbs, paper);
  return { ...others, points, ends: steps(ids), lengths: POINTS.map((list) => kept[list].length / 3) };
}

/** @param {CompactIrregular} record @returns {Irregular} */
export function expandedIrregular({ points, ends, lengths, ...others }) {
  const all = pointsAt(summed(ends), points);
  const [edges, barbs] = lengths.map((length) => 3 * length);
  return {
    ...others,
    edges: all.slice(0, edges),
    barbs: all.slice(edges, edges + barbs),
    paper: all.slice(edges + barbs),
  };
}

/** Without what belongs to boundary edges, which stands last in every list. @param {Irregular} record @returns {Irregular} */
function interior(record) {
  const out = { ...record };
  const marks = { edges: record.boundary, barbs: record.barb_boundary, paper: record.paper_boundary };
  for (const list of POINTS) {
    const { numbers, beside } = LISTS[list];
    const first = marks[list].indexOf(1);
    const count = first < 0 ? marks[list].length : first;
    out[list] = record[list].slice(0, numbers * count);
    for (const name of beside) out[name] = record[name].slice(0, count);
  }
  return out;
}
