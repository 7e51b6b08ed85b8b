import { saveFile } from "../app/saving.js";
import { optionsOf, rangeOf } from "../state/choices.js";
import { choose } from "../state/structure.js";

/**
 * @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../widgets/bind.js").Control} Control
 * @typedef {import("../state/structure.js").Kind} Kind
 */

/** What the two forms of each kind are called. @type {{ readonly [Name in Kind]?: readonly [cells: string, surfaces: string] }} */
const FORMS = {
  sheets: ["Layers of cells", "Dual surfaces"],
  chords: ["Columns of cells", "Curves"],
  blocks: ["Cells", "Walls between them"],
};

/** @param {Context} context */
const lookOf = ({ store }) => store.status.structure;

/** Whether nothing of these kinds is looked at. @param {readonly string[]} kinds */
const unless = (kinds) => (/** @type {Context} */ context) =>
  !context.facts.get("structure") || !kinds.includes(lookOf(context).kind);

const LOOKED = { status: ["structure"], facts: /** @type {const} */ (["structure"]) };
const ANY = ["arcs", "sheets", "chords", "blocks"];

/** How what is looked at is drawn. @type {readonly Control[]} */
export const structureControls = [
  {
    kind: "choice",
    id: "structure-form",
    label: "Drawn as",
    path: "structure.form",
    ...LOOKED,
    hidden: unless(Object.keys(FORMS)),
    options: (context) => {
      const { kind } = lookOf(context);
      const names = (kind !== "none" && FORMS[kind]) || ["", ""];
      return context.tables.choices["structure.form"].map((value, k) => ({ value, name: names[k] }));
    },
  },
  {
    kind: "slider",
    id: "structure-context",
    label: "Context",
    hint: "How much is seen of what is not chosen",
    path: "see_through.opacity",
    ...LOOKED,
    range: [0, 1, 0.05],
    digits: 2,
    hidden: unless(ANY),
    why: (context) => {
      const { kind, chosen, form } = lookOf(context);
      return kind !== "arcs" && form === "cells" && !chosen.length ? "nothing is chosen" : "";
    },
  },
  {
    kind: "slider",
    id: "structure-explode",
    label: "Explode",
    hint: "Blocks drawn apart",
    path: "structure.explode",
    ...LOOKED,
    range: rangeOf("structure.explode", 0.01),
    digits: 2,
    hidden: unless(["blocks"]),
    why: (context) => (lookOf(context).form === "cells" ? "" : "walls stay where they are"),
  },
  {
    kind: "toggle",
    id: "structure-boundary",
    label: "Boundary",
    hint: "Arcs of the boundary's irregular edges, too",
    path: "structure.boundary",
    ...LOOKED,
    hidden: unless(["arcs"]),
    write: (boundary) => ({ structure: { boundary, chosen: [] } }),
  },
  {
    kind: "choice",
    id: "structure-complex",
    label: "Enforced by",
    hint: "Which irregular edges the blocks' walls start from",
    path: "structure.complex",
    ...LOOKED,
    hidden: unless(["blocks"]),
    options: optionsOf("structure.complex"),
    write: (complex) => ({
      structure: { complex: complex === "interior" ? "interior" : "whole", chosen: [] },
    }),
  },
  {
    kind: "toggle",
    id: "structure-curves",
    label: "Base complex",
    hint: "The edges between the walls of all blocks, and where they meet",
    path: "structure.curves",
    ...LOOKED,
    hidden: (context) => !context.facts.get("structure"),
  },
  {
    kind: "actions",
    full: true,
    ...LOOKED,
    hidden: unless(ANY),
    items: [
      {
        name: "Only these",
        hint: "Hide all cells that are in none of the chosen",
        press: (context) => filter(context, "inside"),
        disabled: (context) => !filterable(context),
      },
      {
        name: "Hide",
        hint: "Hide the cells of the chosen",
        press: (context) => filter(context, "outside"),
        disabled: (context) => !filterable(context),
      },
      {
        name: "Go there",
        hint: "Bring the chosen before the eye (Enter in the table)",
        press: ({ app, store }) => {
          const { kind, chosen } = store.status.structure;
          if (kind !== "none") void app.structured.flyTo(kind, chosen);
        },
        disabled: (context) => !lookOf(context).chosen.length,
      },
      {
        name: "Clear",
        hint: "Choose nothing (Escape in the table)",
        press: ({ store }) => store.set(choose([])),
        disabled: (context) => !lookOf(context).chosen.length,
      },
    ],
  },
  {
    kind: "actions",
    label: "Save",
    ...LOOKED,
    hidden: (context) => !context.facts.get("structure"),
    items: [
      {
        name: "Table as CSV",
        text: "CSV",
        press: (context) => void saveTable(context),
        disabled: (context) => lookOf(context).kind === "none",
      },
      { name: "Facts as JSON", text: "JSON", press: (context) => void saveFacts(context) },
    ],
  },
];

/** @param {Context} context */
function filterable(context) {
  const { kind, chosen } = lookOf(context);
  return kind !== "arcs" && chosen.length > 0;
}

/** @param {Context} context @param {"inside" | "outside"} keep */
function filter({ app, store }, keep) {
  const { kind, chosen } = store.status.structure;
  if (kind !== "none") app.structured.filter(kind, chosen, keep);
}

/** @param {Context} context */
async function saveTable({ app, store }) {
  const { kind } = store.status.structure;
  const text = kind === "none" ? null : await app.structured.csv(kind);
  if (text) saveFile(new Blob([text], { type: "text/csv" }), `${app.saving.stem}-${kind}.csv`);
}

/** @param {Context} context */
async function saveFacts({ app }) {
  const found = await app.structured.facts();
  if (found)
    saveFile(
      new Blob([JSON.stringify(found, null, 2)], { type: "application/json" }),
      `${app.saving.stem}-structure.json`,
    );
}
