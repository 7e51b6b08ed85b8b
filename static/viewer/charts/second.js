import { beside } from "./steps.js";

/**
 * The histogram of a mesh with that of a second one over it, where both are of the same quantity.
 *
 * @typedef {import("../state/answers.js").Histogram} Histogram
 *
 * @param {Histogram} own @param {import("../state/facts.js").Facts} facts of the first mesh
 * @returns {Histogram & { beside: ReturnType<typeof beside> | null }}
 */
export function withSecond(own, facts) {
  const other = facts.get("second")?.get("histogram");
  const fits = other && other.quantity === own.quantity && other.edges.length === own.edges.length;
  return { ...own, beside: fits ? beside(own, other) : null };
}
