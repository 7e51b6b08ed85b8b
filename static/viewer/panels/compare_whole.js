import { count } from "../state/numbers.js";
import { followSecond } from "../state/second_facts.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { fileSize } from "../../offline/sizes.js";

/**
 * Counts, findings, structure of both meshes beside each other, and what memory their cores hold.
 *
 * @typedef {import("../widgets/bind.js").Context} Context
 * @typedef {import("../state/facts.js").Facts} Facts
 * @typedef {[name: string, a: string, b: string]} Row
 */

/** @type {readonly [name: string, tell: (facts: Facts) => number | undefined][]} */
const COUNTS = [
  ["Cells", (facts) => facts.get("summary")?.cells],
  ["Vertices", (facts) => facts.get("summary")?.vertices],
  ["Boundary faces", (facts) => facts.get("summary")?.boundary_faces],
  ["Irregular edges", (facts) => irregular(facts.get("description")?.interior_edge_valence)],
];

/** @type {readonly [name: string, tell: (facts: import("../state/answers.js").StructureFacts) => number][]} */
const STRUCTURE = [
  ["Arcs and loops", ({ irregular: graph }) => graph.arcs + graph.loops],
  ["Nodes", ({ irregular: graph }) => graph.nodes],
  ["Sheets", ({ sheets }) => sheets.count],
  ["Chords", ({ chords }) => chords.count],
  ["Blocks", ({ base_complex: base }) => base.blocks],
];

/** @param {Readonly<Record<string, number>> | undefined} valences */
function irregular(valences) {
  if (!valences) return undefined;
  return Object.entries(valences).reduce((sum, [valence, edges]) => (valence === "4" ? sum : sum + edges), 0);
}

/** @param {Context} context */
export function compareWhole(context) {
  const { app, facts } = context;
  const body = h("tbody");
  const table = h(
    "table",
    { class: "table compare-table" },
    h("caption", { class: "visually-hidden" }, "Counts, findings and structure of both meshes"),
    h("thead", {}, h("tr", {}, h("td"), h("th", { scope: "col" }, "A"), h("th", { scope: "col" }, "B"))),
    body,
  );
  const trace = h(
    "button",
    {
      type: "button",
      class: "button",
      onclick: () => {
        trace.disabled = true;
        void app.comparing.trace().finally(() => (trace.disabled = false));
      },
    },
    "Trace both structures",
  );
  const element = h(
    "div",
    { class: "compare-part" },
    h("h3", { class: "compare-title" }, "Both as a whole"),
    table,
    h("div", { class: "actions" }, trace),
  );

  function show() {
    const second = facts.get("second");
    element.hidden = !second;
    if (!second) return;
    const sides = [facts, second];
    const traced = sides.map((side) => side.get("structure"));
    trace.hidden = traced.every(Boolean);
    const memory = app.comparing.memory;
    /** @type {Row[]} */
    const rows = [
      ...COUNTS.map(([name, tell]) => rowOf(name, sides.map(tell))),
      ...findingsOf(sides),
      ...STRUCTURE.filter(() => traced.some(Boolean)).map(([name, tell]) =>
        rowOf(
          name,
          traced.map((one) => (one ? tell(one) : undefined)),
        ),
      ),
    ];
    if (memory.some((bytes) => bytes !== null)) {
      const [a, b] = memory.map((bytes) => (bytes === null || bytes === undefined ? "–" : fileSize(bytes)));
      rows.push(["Memory", a, b ?? "–"]);
    }
    body.replaceChildren(
      ...rows.map(([name, a, b]) =>
        h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, a), h("td", {}, b)),
      ),
    );
  }
  const told = /** @type {const} */ (["summary", "description", "structure", "statistics"]);
  watch(context, { facts: ["second", "apart", ...told] }, show);
  followSecond(context, told, show);
  return element;
}

/** @param {string} name @param {readonly (number | undefined)[]} numbers @returns {Row} */
function rowOf(name, [a, b]) {
  return [name, a === undefined ? "–" : count(a), b === undefined ? "–" : count(b)];
}

/** What the diagnosis found in either. @param {readonly Facts[]} sides @returns {Row[]} */
function findingsOf(sides) {
  const found = sides.map((side) => side.get("description")?.findings);
  const ids = new Set(found.flatMap((some) => some?.map(({ id }) => id) ?? []));
  return [...ids].map((id) => {
    const counts = found.map((some) => some && (some.find((one) => one.id === id)?.count ?? 0));
    return rowOf(capital(id.replaceAll("_", " ")), counts);
  });
}

/** @param {string} words */
const capital = (words) => words[0].toUpperCase() + words.slice(1);
