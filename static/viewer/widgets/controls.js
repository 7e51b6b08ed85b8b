/**
 * Row makers for the panels' tables, typed by what they hold.
 *
 * @typedef {import("./bind.js").Control} Control
 */

/** A row of buttons. @param {Omit<import("./bind.js").ActionsControl, "kind">} row @returns {Control} */
export const buttons = (row) => ({ kind: "actions", ...row });

/** Controls folded away until asked for. @param {string} id @param {string} label @param {readonly Control[]} items @returns {Control} */
export const more = (id, label, items) => ({ kind: "more", id, label, items });
