import { count, counted, decimal } from "../state/numbers.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";

/** @typedef {import("../state/answers.js").StructureFacts} StructureFacts */

/** What is told of the whole: name, and how it follows from the facts; null where there is nothing to tell. @type {readonly [name: string, tell: (facts: StructureFacts) => string | null][]} */
const ROWS = [
  ["Class", (facts) => facts.class],
  ["Arcs' ends inside", ({ irregular }) => some(meeting(irregular.node_types, 1))],
  ["T junctions inside", ({ irregular }) => some(meeting(irregular.node_types, 3))],
  ["Cells per block", ({ base_complex: { cells_per_block: cells } }) => (cells ? decimal(cells) : null)],
  ["Blocks by the inside alone", (facts) => count(facts.interior_base_complex.blocks)],
  [
    "Base complex",
    ({ base_complex: base }) =>
      [
        counted(base.vertices, "vertex"),
        counted(base.edges + base.edge_loops, "edge"),
        counted(base.faces, "face"),
      ].join(", "),
  ],
  ["Base sheets", ({ base_complex: base }) => count(base.base_sheets)],
  ["Base chords", ({ base_complex: base }) => count(base.base_chords)],
  [
    "Irregular vertices",
    ({ irregular_vertex_share: share }) =>
      share === null ? null : `${decimal(100 * share)} % of those inside`,
  ],
];

/** Nodes inside at which so many irregular edges meet: one where an arc ends, three at a T junction. @param {Readonly<Record<string, number>>} types @param {number} edges */
function meeting(types, edges) {
  const found = Object.entries(types).filter(
    ([name]) => name.startsWith("i ") && name.split(" ").length === edges + 1,
  );
  return found.reduce((sum, [, number]) => sum + number, 0);
}

/** @param {number} number */
const some = (number) => (number ? count(number) : null);

/** How many types of nodes and sizes of blocks are listed. */
const MOST = 12;

/**
 * What is known of the structure as a whole, types of nodes, sizes of blocks.
 *
 * @param {import("../widgets/bind.js").Context} context
 */
export function structureFacts(context) {
  const list = h("dl", { class: "facts" });
  const nodes = tally(
    "Nodes by type",
    "Type",
    "i: inside, b: on the boundary; and the valences of the irregular edges that meet there",
  );
  const sizes = tally(
    "Blocks by size",
    "Size",
    "Cells along the three edges of a box; of a ring in brackets its length",
  );
  const element = h(
    "details",
    { class: "more", id: "structure-facts" },
    h("summary", { class: "more-head" }, "In numbers"),
    list,
    nodes.element,
    sizes.element,
  );
  watch(context, { facts: ["structure"] }, () => {
    const facts = context.facts.get("structure");
    element.hidden = !facts;
    if (!facts) return;
    const rows = ROWS.map(([name, tell]) => /** @type {const} */ ([name, tell(facts)])).filter(
      ([, text]) => text,
    );
    list.replaceChildren(...rows.flatMap(([name, text]) => [h("dt", {}, name), h("dd", {}, text)]));
    nodes.show(facts.irregular.node_types);
    sizes.show(facts.base_complex.dims);
  });
  return element;
}

/** A table of counts by name, the most frequent first. @param {string} caption @param {string} head @param {string} hint */
function tally(caption, head, hint) {
  const body = h("tbody");
  const rest = h("p", { class: "quiet" });
  const table = h(
    "table",
    { class: "table" },
    h("caption", {}, caption),
    h(
      "thead",
      {},
      h("tr", {}, h("th", { scope: "col", title: hint }, head), h("th", { scope: "col" }, "Number")),
    ),
    body,
  );
  const element = h("div", {}, table, rest);
  /** @param {Readonly<Record<string, number>>} counts */
  const show = (counts) => {
    const rows = Object.entries(counts).sort(([, a], [, b]) => b - a);
    element.hidden = !rows.length;
    body.replaceChildren(
      ...rows
        .slice(0, MOST)
        .map(([name, number]) =>
          h("tr", {}, h("th", { scope: "row" }, name.replaceAll("x", " × ")), h("td", {}, count(number))),
        ),
    );
    rest.textContent = rows.length > MOST ? `and ${count(rows.length - MOST)} more` : "";
  };
  return { element, show };
}
