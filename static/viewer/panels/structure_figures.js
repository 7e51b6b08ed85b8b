import { count, counted } from "../state/numbers.js";
import { NAMES, inWords, lookAt } from "../state/structure.js";
import { watch } from "../widgets/bind.js";
import { h, setAttribute, setText } from "../widgets/dom.js";

/** @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../state/structure.js").Kind} Kind */
/** @typedef {import("../state/answers.js").StructureFacts} StructureFacts */

/** How many there are of each kind, and what of it is said beside. @type {{ kind: Kind, count: (facts: StructureFacts) => number, of: (facts: StructureFacts) => string }[]} */
const FIGURES = [
  {
    kind: "arcs",
    count: ({ irregular }) => irregular.arcs + irregular.loops,
    of: ({ irregular }) =>
      `${counted(irregular.arcs, "arc")} and ${counted(irregular.loops, "loop")} of irregular edges inside, ${counted(irregular.nodes, "node")}`,
  },
  {
    kind: "sheets",
    count: ({ sheets }) => sheets.count,
    of: ({ sheets }) => withKinds(counted(sheets.count, "sheet"), sheets),
  },
  {
    kind: "chords",
    count: ({ chords }) => chords.count,
    of: ({ chords }) => withKinds(counted(chords.count, "chord"), chords),
  },
  {
    kind: "blocks",
    count: ({ base_complex: base }) => base.blocks,
    of: ({ base_complex: base }) => counted(base.blocks, "block"),
  },
];

/** @param {string} all @param {Readonly<Record<string, number>>} facts counts by kind */
function withKinds(all, facts) {
  const kinds = Object.entries(facts).filter(([name, number]) => name !== "count" && number);
  return [all, ...kinds.map(([name, number]) => `${count(number)} ${name.replaceAll("_", "-")}`)].join(", ");
}

/** Cells per block below which the base complex is as fine as the mesh. */
const DISSOLVED = 2;

/**
 * How many arcs, sheets, chords and blocks there are: buttons that show them. They are traced when they come into sight.
 *
 * @param {Context} context
 */
export function structureFigures(context) {
  const { app, facts, store } = context;
  const buttons = FIGURES.map((figure) => {
    const number = h("strong", {}, "–");
    const button = h(
      "button",
      { type: "button", class: "figure-button", "aria-pressed": "false", onclick: () => press(figure.kind) },
      number,
      h("span", {}, NAMES[figure.kind][1]),
    );
    return { ...figure, button, number };
  });
  /** @param {Kind} kind */
  const press = (kind) => {
    const { status } = store;
    store.seal();
    store.set(lookAt(status, status.structure.kind === kind ? "none" : kind));
  };
  const bar = h("progress", { class: "tracing-bar", "aria-label": "Tracing", max: 1 });
  const words = h("p", { class: "quiet", role: "status" });
  const note = h("p", { class: "structure-note" });
  const element = h(
    "div",
    { class: "structure-figures" },
    h(
      "div",
      { class: "figure-row", role: "group", "aria-label": "Structure" },
      ...buttons.map((one) => one.button),
    ),
    bar,
    words,
    note,
  );
  const wanted = () => {
    if (element.checkVisibility() || store.status.structure.kind !== "none") void app.structured.trace();
  };
  new IntersectionObserver((seen) => seen.some(({ isIntersecting }) => isIntersecting) && wanted()).observe(
    element,
  );
  watch(
    context,
    { facts: ["summary", "core", "tracing", "structure", "shown"], status: ["structure"] },
    () => {
      const structure = facts.get("structure");
      const tracing = facts.get("tracing");
      const { kind, chosen } = store.status.structure;
      for (const { kind: own, button, number, count: of, of: title } of buttons) {
        setText(number, structure ? count(of(structure)) : "–");
        button.disabled = !structure;
        button.title = structure ? title(structure) : "";
        setAttribute(button, "aria-pressed", String(own === kind));
        setAttribute(button, "aria-label", `${number.textContent} ${NAMES[own][1]}`);
      }
      bar.hidden = !tracing;
      if (tracing) bar.value = tracing.done / tracing.of;
      setText(
        words,
        tracing?.next ? `Tracing ${tracing.next}` : structure ? chosenInWords(kind, chosen) : "",
      );
      const notes = structure
        ? [...notesOf(structure, facts.get("summary")?.cells ?? 0), tooMany(context)]
        : [];
      setText(note, notes.filter(Boolean).join(" "));
      note.hidden = !note.textContent;
      words.hidden = !words.textContent;
      if (!structure && !tracing) wanted();
    },
  );
  return element;
}

/** @param {import("../state/status.js").Status["structure"]["kind"]} kind @param {readonly number[]} chosen */
function chosenInWords(kind, chosen) {
  return kind === "none" || !chosen.length ? "" : `Chosen: ${inWords(kind, chosen)}`;
}

/** What has to be known to read the figures. @param {StructureFacts} structure @param {number} cells */
function notesOf(structure, cells) {
  const { base_complex: base, sheets, skipped } = structure;
  const notes = skipped ? [`Not traced: ${skipped}. Structure ends there.`] : [];
  const share = base.cells_per_block ?? Infinity;
  if (share < DISSOLVED && cells > 1 && base.blocks > 100)
    notes.push(
      `${count(base.blocks)} blocks of ${counted(cells, "cell")}: the base complex is almost as fine as the mesh, as in octree-like ` +
        `meshes. Its ${counted(sheets.count, "sheet")} tell more.`,
    );
  return notes;
}

/** Why nothing is drawn of sheets or chords that none is chosen of; empty where something is. @param {Context} context */
function tooMany({ store, facts, tables }) {
  const { kind, form, chosen } = store.status.structure;
  const all = (kind === "sheets" || kind === "chords") && form === "surfaces" && !chosen.length;
  if (!all || (facts.get("shown")?.cells ?? 0) <= tables.most_at_once) return "";
  return `All ${NAMES[kind][1]} of more than ${count(tables.most_at_once)} cells are too many to draw at once: choose some.`;
}
