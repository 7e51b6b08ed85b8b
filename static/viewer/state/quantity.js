import { comparedOf, metricOf, tracedOf } from "./tables.js";
import { unitOf } from "./units.js";

/**
 * What is looked at, coloured and filtered by: a quantity, that is a metric or one of the file's attributes; and its scale.
 *
 * @typedef {object} Known  what tells of it
 * @property {{ status: import("./status.js").Status }} store
 * @property {import("./facts.js").Facts} facts
 * @property {import("./tables.js").Tables} tables
 *
 * @typedef {{ id: string, name: string, symbol: string, variant: string, attribute: boolean, lengthPower: number, unit: string,
 *   worstValue: number, bestValue: number,
 *   outer: readonly [number, number] | null,
 *   acceptable: readonly [number | null, number | null] | null }} Quantity
 */

/** @param {Known} known @returns {Quantity} */
export function quantityOf({ store, facts, tables }) {
  const { by, metric, attribute } = store.status.colour;
  const id = by === "attribute" && attribute ? attribute : metric;
  const row = metricOf(tables, id);
  const histogram = facts.get("histogram");
  const statistics = facts.get("statistics")[id];
  const axis = histogram?.quantity === id ? histogram : null;
  const low = axis?.low ?? statistics?.min ?? 0;
  const high = axis?.high ?? statistics?.max ?? 1;
  const compared = comparedOf(tables, id);
  const better = row?.better ?? compared?.better ?? "low";
  const lengthPower = row?.length_power ?? compared?.length_power ?? 0; // of attributes nobody knows
  return {
    id,
    name:
      row?.name ?? compared?.name ?? tracedOf(tables, id)?.name ?? attributeName(facts.get("summary"), id),
    symbol: row?.symbol ?? "",
    variant: row?.variant ?? "",
    attribute: !row,
    lengthPower,
    unit: unitOf(store.status, lengthPower),
    bestValue: statistics?.best_value ?? (better === "low" ? low : high),
    worstValue: statistics?.worst_value ?? (better === "low" ? high : low),
    acceptable: row?.acceptable_range ?? null,
    outer: outerOf(statistics),
  };
}

/** The 5th and 95th percentile, if they differ. @param {import("./answers.js").Statistics | undefined} statistics @returns {[number, number] | null} */
function outerOf(statistics) {
  const [low, high] = [statistics?.percentiles["5"], statistics?.percentiles["95"]];
  return typeof low === "number" && typeof high === "number" && low < high ? [low, high] : null;
}

/** Part of a range's end by which a value may pass it: rounding. */
const ROUNDING = 1e-12;

/** Whether a value is outside of a range, but for rounding. @param {number} value @param {readonly [number | null, number | null]} range */
export function isOutside(value, [low, high]) {
  return (
    (low !== null && value < low - ROUNDING * Math.abs(low)) ||
    (high !== null && value > high + ROUNDING * Math.abs(high))
  );
}

/** @param {import("./facts.js").MeshSummary | null} summary @param {string} id */
function attributeName(summary, id) {
  return summary?.attributes?.find((one) => one.id === id)?.name ?? id;
}

/** Metrics, the file's attributes, what comes out of the structure: for a combo box. @param {Known} known */
export function quantityOptions({ facts, tables }) {
  const metrics = tables.metrics.map(({ id, name }) => ({ value: id, name, group: "Quality" }));
  const attributes = (facts.get("summary")?.attributes ?? []).map((one) => ({
    value: one.id,
    name: one.name,
    group: one.on === "cell" ? "Of cells" : "Of points",
  }));
  const traced = tables.traced.map(({ id, name }) => ({ value: id, name, group: "Structure" }));
  const told = facts.get("comparison");
  const compared = (told ? tables.compared : [])
    .filter(({ cellwise }) => told?.same_cells || !cellwise)
    .map(({ id, name }) => ({ value: id, name, group: "Comparison" }));
  return [...metrics, ...attributes, ...traced, ...compared];
}

/** The map of changes, whose middle is no change. */
const DIVERGING = "diverging";

/**
 * The partial status that makes a metric or attribute the one looked at. Changes come with a map whose middle is no change.
 *
 * @param {string} id @param {{ store: import("./store.js").StatusStore, tables: import("./tables.js").Tables }} known
 * @returns {import("./status.js").PartialStatus}
 */
export function chooseQuantity(id, { store, tables }) {
  const { by, map } = store.status.colour;
  const signed = Boolean(comparedOf(tables, id)?.metric);
  const fitting =
    signed === (map === DIVERGING) ? {} : { map: signed ? DIVERGING : store.defaults.colour.map };
  if (metricOf(tables, id))
    return {
      colour: { metric: id, ...(by === "attribute" ? { by: "quality" } : {}), range: null, ...fitting },
    };
  return { colour: { by: "attribute", attribute: id, range: null, ...fitting } };
}
