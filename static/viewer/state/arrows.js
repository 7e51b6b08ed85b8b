import { count, counted, decimal } from "./numbers.js";

/**
 * Vectors of the file that are drawn as arrows.
 *
 * @typedef {object} Told  what is known of the arrows on the screen
 * @property {number} drawn
 * @property {number | null} longest length of the longest vector of the mesh, in the file's unit
 * @property {number} not_finite faces without one, as their vector is not finite
 * @property {number} zero faces without one, as their vector is nothing
 */

/** @param {import("./answers.js").Arrows} record @returns {Told} */
export function toldOf({ inward, longest, not_finite, zero }) {
  return { drawn: inward.length, longest, not_finite, zero };
}

/**
 * The attributes that have a direction, for a combo box; in groups where both cells and points have some.
 *
 * @param {import("./facts.js").MeshSummary | null} summary @returns {{ value: string, name: string, group?: string }[]}
 */
export function vectorOptions(summary) {
  const rows = (summary?.attributes ?? []).filter(({ components }) => components === 3);
  const alike = new Set(rows.map(({ on }) => on)).size < 2;
  return rows.map(({ id, on }) => {
    const option = { value: id, name: id.slice(on.length + 1) };
    return alike ? option : { ...option, group: on === "cell" ? "Of cells" : "Of points" };
  });
}

/** How many arrows there are, what the length stands for, and which faces have none. @param {Told} told */
export function inWords({ drawn, longest, not_finite, zero }) {
  const parts = [
    ...(not_finite ? [`${count(not_finite)} not finite`] : []),
    ...(zero ? [`${count(zero)} zero`] : []),
  ];
  const scale = longest ? `; longest vector: ${decimal(longest)}` : "";
  const without = parts.length ? `. Faces without: ${parts.join(", ")}` : "";
  return `${drawn ? counted(drawn, "arrow") : "no arrows"}${drawn ? scale : ""}${without}`;
}
