import { choose } from "../state/structure.js";
import { watch } from "../widgets/bind.js";
import { DataTable } from "../widgets/data_table.js";
import { h } from "../widgets/dom.js";

/** @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../state/structure.js").Kind} Kind */

/** What columns are called, by the core's names. @type {Readonly<Record<string, { name: string, hint?: string }>>} */
const COLUMNS = {
  number: { name: "No." },
  valence: { name: "Valence", hint: "Cells around each of its edges" },
  edges: { name: "Edges" },
  closed: { name: "Closed", hint: "It has no end, and is nowhere on the boundary" },
  boundary: { name: "Boundary", hint: "It lies on the boundary" },
  from: { name: "From", hint: "Vertex at one end" },
  to: { name: "To", hint: "Vertex at the other end" },
  cells: { name: "Cells" },
  crossings: {
    name: "Crossings",
    hint: "How often it crosses a cell: more often than it has cells where it crosses itself",
  },
  kind: { name: "Kind" },
  one_sided: { name: "One-sided", hint: "Its edges can't be directed alike, as on a Möbius strip" },
  base_sheet: { name: "Base sheet", hint: "Sheets of one number run side by side through the same blocks" },
  length: { name: "Length", hint: "Cells that it passes" },
  base_chord: { name: "Base chord", hint: "Chords of one number run side by side through the same blocks" },
  i: { name: "i", hint: "Cells along the shortest of its three edges" },
  j: { name: "j" },
  k: { name: "k" },
};

/** @param {import("../state/answers.js").StructureColumn} column @returns {import("../widgets/table/columns.js").Column} */
function columnOf({ id, values, words }) {
  const kind = words ? "word" : values instanceof Uint8Array ? "flag" : "number";
  return {
    id,
    values,
    words: words ?? [],
    kind,
    ...COLUMNS[id],
    ...(PLAIN.has(id) ? { format: String } : {}),
  };
}

/** Numbers that name something: written without marks between thousands. */
const PLAIN = new Set(["number", "from", "to", "base_sheet", "base_chord"]);

/**
 * All things of the kind that is looked at: choose some to see them, with Enter or a double click go there.
 *
 * @param {Context} context
 */
export function structureTable(context) {
  const { app, facts, store } = context;
  const table = new DataTable({
    label: "What the structure consists of",
    choose: (numbers) => store.set(choose(numbers), { undo: "structure" }),
    activate: (number) => {
      const { kind } = store.status.structure;
      if (kind !== "none") void app.structured.flyTo(kind, [number]);
    },
  });
  const element = h("div", { class: "structure-table" }, table.element);
  /** @type {unknown} */
  let shown = null;
  watch(context, { facts: ["structure"], status: ["structure"] }, async () => {
    const { kind } = store.status.structure;
    const structure = facts.get("structure");
    element.hidden = !structure || kind === "none";
    if (!structure || kind === "none") return;
    const found = await app.structured.table(kind);
    const now = store.status.structure;
    if (!found || facts.get("structure") !== structure || now.kind !== kind) return;
    if (found !== shown) {
      shown = found;
      const cells = found.columns.find(({ id }) => id === "cells")?.values;
      const columns = found.columns.filter(
        ({ id, values }) =>
          (!IDLE.has(id) || values.some(Boolean)) &&
          (id !== "crossings" || values.some((value, row) => value !== cells?.[row])),
      );
      table.show(columns.map(columnOf), found.rows);
    }
    table.mark(now.chosen);
    element.hidden = found.rows === 0;
  });
  return element;
}

/** Columns that are left out where nothing is so; crossings are, where they are as many as cells. */
const IDLE = new Set(["boundary", "closed", "one_sided"]);
