import { rangeOf } from "../state/choices.js";

/**
 * Row makers for the panels' tables, typed by what they hold.
 *
 * @typedef {import("./bind.js").Control} Control
 */

/** A row of buttons. @param {Omit<import("./bind.js").ActionsControl, "kind">} row @returns {Control} */
export const buttons = (row) => ({ kind: "actions", ...row });

/**
 * A slider over whole numbers, whose box takes all that the schema allows.
 *
 * @param {{ id: string, label: string, hint?: string, path: string, range: readonly [number, number, number],
 *   hidden?: (context: import("./bind.js").Context) => boolean, status?: readonly string[] }} row
 * @returns {Control}
 */
export const wholeNumber = (row) => ({
  kind: "slider",
  digits: 0,
  box: { range: rangeOf(row.path, 1) },
  ...row,
});

/** Controls folded away until asked for. @param {string} id @param {string} label @param {readonly Control[]} items @returns {Control} */
export const more = (id, label, items) => ({ kind: "more", id, label, items });
