import { clear, formatCells, isClear, isolate, parseCells, toggleTool } from "../state/picking.js";
import { buttons } from "../widgets/controls.js";

/**
 * @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../widgets/bind.js").Control} Control
 * @typedef {import("../widgets/bind.js").Action} Action
 */

/** @param {Context} context @returns {import("../state/picking.js").Picking} */
const pickingOf = ({ store }) => store.status.filters.picking;

/** @param {Context} context */
const cellsOf = ({ facts }) => facts.get("summary")?.cells ?? 0;

/** @param {string} name @param {import("../state/facts.js").Tool} tool @param {string} hint @returns {Action} */
const toolButton = (name, tool, hint) => ({
  name,
  text: name,
  hint,
  press: ({ facts }) => toggleTool(facts, tool),
  pressed: ({ facts }) => facts.get("tool") === tool,
});

/** @param {string} value @param {Context} context */
const parsed = (value, context) => parseCells(value, cellsOf(context), context.facts.get("numbering"));

/** Picked cells by number. @param {"hidden" | "shown"} list @param {string} label @returns {Control} */
const byNumber = (list, label) => ({
  kind: "text",
  id: `pick-${list}`,
  label,
  hint: "3, 10-14",
  status: [`filters.picking.${list}`],
  facts: ["numbering"],
  read: (context) => formatCells(pickingOf(context)[list], context.facts.get("numbering")),
  check: (value, context) => parsed(value, context).wrong,
  write: (value, context) => ({
    filters: { picking: { enabled: true, [list]: parsed(value, context).cells } },
  }),
});

/** Rows of hand-picking (SPEC F4). @type {readonly Control[]} */
export const pickingControls = [
  buttons({
    label: "Pick",
    enabled: "filters.picking.enabled",
    facts: ["tool"],
    items: [
      toolButton("Dig", "dig", "A click hides a cell (D, or hold ctrl)"),
      toolButton("Undig", "undig", "A click shows the hidden cell behind a face (U, or hold shift)"),
      toolButton("Isolate", "isolate", "A click hides all other cells (J)"),
    ],
    more: [
      byNumber("hidden", "Hidden"),
      byNumber("shown", "Shown"),
      buttons({
        label: "",
        status: ["filters.picking"],
        items: [
          {
            name: "Isolate the cells in “Shown”",
            text: "Isolate shown",
            disabled: (context) => !pickingOf(context).shown.length,
            press: (context) =>
              context.store.set({ filters: { picking: isolate(pickingOf(context).shown) } }),
          },
          {
            name: "Clear what was picked",
            text: "Clear",
            icon: "clear",
            disabled: (context) => isClear(pickingOf(context)),
            press: (context) => context.store.set({ filters: { picking: clear() } }),
          },
        ],
      }),
    ],
  }),
];
