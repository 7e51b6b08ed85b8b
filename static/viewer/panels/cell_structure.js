import { NAMES, lookAt } from "../state/structure.js";
import { h } from "../widgets/dom.js";

/**
 * @typedef {import("../widgets/bind.js").MeshContext} Context
 * @typedef {import("../state/structure.js").Kind} Kind
 */

/**
 * The three sheets of a cell, its chords and its block, each to be looked at; or a button that has them traced.
 *
 * @param {Context} context @param {import("../state/answers.js").Inspection} cell
 */
export function structureOfCell(context, { structure }) {
  const { app, facts } = context;
  if (!structure) {
    const trace = (/** @type {MouseEvent} */ { currentTarget }) => {
      /** @type {HTMLButtonElement} */ (currentTarget).disabled = true;
      void app.structured.trace();
    };
    return h(
      "p",
      { class: "cell-list" },
      h("button", { type: "button", class: "link", onclick: trace }, "Its sheets, chords and block"),
    );
  }
  if (structure.block === null)
    return h(
      "p",
      { class: "cell-list quiet" },
      "In no sheet, chord or block: it is not a hexahedron of eight vertices",
    );
  const blocks = facts.get("structure") ? [structure.block] : [];
  return h(
    "p",
    { class: "cell-list" },
    ...things(context, "sheets", structure.sheets),
    ...things(context, "chords", structure.chords),
    ...things(context, "blocks", blocks),
  );
}

/** @param {Context} context @param {Kind} kind @param {readonly number[]} numbers */
function things(context, kind, numbers) {
  const own = [...new Set(numbers)];
  if (!own.length) return [];
  const [one, many] = NAMES[kind];
  const name = own.length === 1 ? one : many;
  const show = (/** @type {readonly number[]} */ some) => {
    context.store.seal();
    context.store.set(lookAt(context.store.status, kind, some));
  };
  const link = (
    /** @type {string} */ text,
    /** @type {readonly number[]} */ some,
    /** @type {string} */ title,
  ) => h("button", { type: "button", class: "link", title, onclick: () => show(some) }, text);
  return [
    own.length === 1
      ? h("span", { class: "quiet" }, `${capital(name)} `)
      : link(capital(name), own, `Look at these ${name}`),
    ...own.map((number) => link(String(number), [number], `Look at ${one} ${number}`)),
  ];
}

/** @param {string} word */
const capital = (word) => word[0].toUpperCase() + word.slice(1);
