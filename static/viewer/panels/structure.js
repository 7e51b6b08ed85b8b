import { VALENCE_STYLES } from "../colours/valence.js";
import { IRREGULAR_STEPS, optionsOf, rangeOf } from "../state/choices.js";
import { count, counted } from "../state/numbers.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { meshFacts } from "./mesh_facts.js";
import { structureControls } from "./structure_controls.js";
import { structureFacts } from "./structure_facts.js";
import { structureFigures } from "./structure_figures.js";
import { structureMatrix } from "./structure_matrix.js";
import { structureTable } from "./structure_table.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/** Rows of the legend: valence from, to, its words. They stand in the order of `VALENCE_STYLES`. */
const CLASSES = [
  { name: "low", words: "2 and fewer", test: (/** @type {number} */ n) => n <= 2 },
  { name: "three", words: "3", test: (/** @type {number} */ n) => n === 3 },
  { name: "four", words: "4 (on the boundary)", test: (/** @type {number} */ n) => n === 4 },
  { name: "five", words: "5", test: (/** @type {number} */ n) => n === 5 },
  { name: "high", words: "6 and more", test: (/** @type {number} */ n) => n >= 6 },
];

/** @param {Context} context @returns {import("../state/answers.js").IrregularCounts | null} */
function countsOf({ facts }) {
  const drawn = facts.get("irregular");
  if (drawn) return drawn;
  const description = facts.get("description");
  if (!description?.interior_edge_valence) return null;
  const without = (
    /** @type {Record<string, number> | undefined} */ valences,
    /** @type {string} */ regular,
  ) => Object.fromEntries(Object.entries(valences ?? {}).filter(([valence]) => valence !== regular));
  return {
    interior: without(description.interior_edge_valence, "4"),
    boundary: without(description.boundary_edge_valence, "2"),
  };
}

/** @param {Record<string, number>} valences @param {(n: number) => boolean} test */
function total(valences, test) {
  return Object.entries(valences).reduce((sum, [valence, n]) => (test(Number(valence)) ? sum + n : sum), 0);
}

/** @type {import("../widgets/section.js").Section} */
export const structure = {
  id: "structure",
  title: "Structure",
  digestOf: { facts: ["description", "irregular", "structure"] },
  digest: (context) => {
    const counts = countsOf(context);
    const structure = context.facts.get("structure");
    const traced = structure
      ? [counted(structure.sheets.count, "sheet"), counted(structure.base_complex.blocks, "block")]
      : [];
    const edges = counts ? [`${count(total(counts.interior, () => true))} irregular edges`] : [];
    return [...edges, ...traced].join(", ");
  },
  controls: [
    {
      kind: "slider",
      id: "irregular",
      label: "Irregular",
      hint: "Interior edges with other than four cells",
      path: "irregular.mode",
      facts: ["description", "irregular"],
      status: ["irregular.boundary"],
      range: rangeOf("irregular.mode", 1),
      names: IRREGULAR_STEPS,
      why: (context) => {
        const counts = countsOf(context);
        const boundary = context.store.status.irregular.boundary;
        return counts &&
          !total(counts.interior, () => true) &&
          !(boundary && total(counts.boundary, () => true))
          ? "this mesh has no irregular edges"
          : "";
      },
    },
    {
      kind: "toggle",
      id: "irregular-boundary",
      label: "Boundary",
      hint: "Boundary edges with other than two cells, too",
      path: "irregular.boundary",
    },
    {
      kind: "choice",
      id: "irregular-palette",
      label: "Colours",
      hint: "Of the numbers of cells around an edge",
      path: "irregular.palette",
      options: optionsOf("irregular.palette"),
    },
    { kind: "custom", render: legend },
    { kind: "custom", render: structureFigures },
    { kind: "custom", render: structureTable },
    ...structureControls,
    { kind: "custom", render: structureMatrix },
    { kind: "custom", render: structureFacts },
    { kind: "custom", render: meshFacts },
  ],
};

/** A piece of wire, in colour and breadth. @param {Context} context @param {number} row of the styles */
function mark({ store }, row) {
  const { wire, width } = VALENCE_STYLES[store.status.irregular.palette][row];
  const element = h("span", { class: "valence", "aria-hidden": "true" });
  element.style.background = wire;
  element.style.height = `${2.5 * width}px`;
  return element;
}

/** Counts by valence, each with the colour of its wires. @param {Context} context */
function legend(context) {
  const body = h("tbody");
  const table = h(
    "table",
    { class: "table legend" },
    h("caption", { class: "visually-hidden" }, "Irregular edges by number of cells around them"),
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        h("th", { scope: "col" }, "Cells around"),
        h("th", { scope: "col" }, "Inside"),
        h("th", { scope: "col" }, "Boundary"),
      ),
    ),
    body,
  );
  watch(context, { facts: ["description", "irregular"], status: ["irregular.palette"] }, () => {
    const counts = countsOf(context);
    table.hidden = !counts;
    if (!counts) return;
    const rows = CLASSES.map(({ name, words, test }) => ({
      name,
      words,
      inside: total(counts.interior, test),
      outside: total(counts.boundary, test),
    }));
    body.replaceChildren(
      ...rows
        .filter(({ inside, outside }) => inside || outside)
        .map(({ name, words, inside, outside }) =>
          h(
            "tr",
            {},
            h(
              "th",
              { scope: "row" },
              mark(
                context,
                CLASSES.findIndex((one) => one.name === name),
              ),
              words,
            ),
            h("td", {}, count(inside)),
            h("td", {}, count(outside)),
          ),
        ),
    );
  });
  return table;
}
