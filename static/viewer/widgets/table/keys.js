import { firstInSight, page } from "./sight.js";

/**
 * @typedef {import("./sight.js").Sight} Sight @typedef {import("./row_choice.js").Way} Way
 * @typedef {Pick<KeyboardEvent, "ctrlKey" | "metaKey" | "shiftKey" | "altKey">} Held
 */

/** Where a key leads from a place. @type {Record<string, (place: number, sight: Sight) => number>} */
const STEPS = {
  ArrowDown: (place) => place + 1,
  ArrowUp: (place) => place - 1,
  PageDown: (place, sight) => place + page(sight),
  PageUp: (place, sight) => place - page(sight),
  Home: () => 0,
  End: (_, { rows }) => rows - 1,
};

/**
 * The place a key leads to.
 *
 * @param {Held & { key: string }} event @param {number | null} place of the cursor; null: there is none yet
 * @param {Sight} sight
 * @returns {number | null} null where the key leads nowhere
 */
export function placeByKey({ key, altKey }, place, sight) {
  const step = altKey || !sight.rows ? undefined : STEPS[key];
  if (!step) return null;
  const next = place === null && key.startsWith("Arrow") ? firstInSight(sight) : step(place ?? 0, sight);
  return Math.max(0, Math.min(sight.rows - 1, next));
}

/** How a row is meant that a key leads to. @param {Held} held @returns {Way} */
export function wayOfKey({ ctrlKey, metaKey, shiftKey }) {
  if (shiftKey) return "extend";
  return ctrlKey || metaKey ? "move" : "one";
}

/** How a row is meant that is clicked. @param {Held} held @returns {Way} */
export function wayOfClick({ ctrlKey, metaKey, shiftKey }) {
  const more = ctrlKey || metaKey;
  if (shiftKey) return more ? "add" : "extend";
  return more ? "toggle" : "one";
}
