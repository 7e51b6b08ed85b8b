import { NAMES, inWords } from "../state/structure.js";
import { watch } from "../widgets/bind.js";
import { h, setText } from "../widgets/dom.js";

/** @typedef {import("../state/status.js").Status["filters"]["structure"]} Filter */

const KINDS = /** @type {const} */ (["blocks", "sheets", "chords"]);

/** Blocks, sheets, chords: none. */
const NOTHING = { blocks: [], sheets: [], chords: [] };

/** "only block 3", "without sheets 1 and 2"; empty where it hides nothing. @param {Filter} filter */
export function filterInWords(filter) {
  const kinds = KINDS.filter((kind) => filter[kind].length);
  if (!kinds.length) return "";
  const words = kinds.map((kind) => inWords(kind, filter[kind])).join(", ");
  return `${filter.keep === "inside" ? "only" : "without"} ${words}`;
}

/**
 * What the filter by structure does, once something was isolated or hidden by it: it can be switched off, and forgotten.
 *
 * @param {import("../widgets/bind.js").Context} context
 */
export function structureFilter(context) {
  const { store } = context;
  const words = h("span", { class: "structure-filter-words" });
  const box = h("input", {
    type: "checkbox",
    class: "row-switch",
    id: "structure-filter",
    onchange: () => store.set({ filters: { structure: { enabled: box.checked } } }),
  });
  const clear = h(
    "button",
    {
      type: "button",
      class: "link",
      "aria-label": "Show what is hidden by structure",
      onclick: () => store.set({ filters: { structure: { enabled: true, keep: "inside", ...NOTHING } } }),
    },
    "clear",
  );
  const element = h(
    "div",
    { class: "structure-filter" },
    box,
    h("label", { class: "row-label", for: box.id }, "Structure"),
    words,
    clear,
  );
  watch(context, { status: ["filters.structure"] }, () => {
    const { structure } = store.status.filters;
    const told = filterInWords(structure);
    element.hidden = !told;
    box.checked = structure.enabled;
    setText(words, told);
    words.title = KINDS.filter((kind) => structure[kind].length)
      .map((kind) => `${NAMES[kind][1]} ${structure[kind].slice(0, 50).join(", ")}`)
      .join("; ");
  });
  return element;
}
