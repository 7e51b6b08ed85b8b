import { FLIGHT } from "../app/views.js";
import { categoryColour } from "../colours/palettes.js";
import { count, counted } from "../state/numbers.js";
import { clear, dig, isClear, isolate, undig } from "../state/picking.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { swatch } from "../widgets/swatch.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/** @param {Context} context */
const partsOf = ({ store }) => store.status.filters.parts;

/** @param {Context} context @param {import("../state/picking.js").Picking} parts */
const set = ({ store }, parts) => store.set({ filters: { parts } });

/**
 * The parts that share no face, the largest first: each can be hidden, or shown alone, and all coloured.
 *
 * @param {Context} context
 */
export function partList(context) {
  const head = h("summary", { class: "more-head" });
  const list = h("ul", { class: "parts" });
  const rest = h("p", { class: "quiet" });
  const colour = h(
    "button",
    {
      type: "button",
      class: "button",
      onclick: () =>
        context.store.set({
          colour: { by: context.store.status.colour.by === "part" ? "sides" : "part" },
        }),
    },
    "Colour by part",
  );
  const all = h(
    "button",
    { type: "button", class: "button", onclick: () => set(context, clear()) },
    "Show all",
  );
  const element = h(
    "details",
    { class: "more", id: "parts" },
    head,
    list,
    rest,
    h("div", { class: "actions" }, colour, all),
  );
  watch(context, { facts: ["description"], status: ["filters.parts", "colour.by"] }, () => {
    const { part_cells: cells = [], components = 0 } = context.facts.get("description") ?? {};
    element.hidden = components < 2 || !cells.length;
    if (element.hidden) return;
    const parts = partsOf(context);
    const coloured = context.store.status.colour.by === "part";
    head.textContent = `Parts (${count(components)})`;
    list.replaceChildren(...cells.map((number, part) => row(context, { part, number, coloured })));
    rest.hidden = components <= cells.length;
    rest.textContent = `and ${counted(components - cells.length, "smaller one")}`;
    colour.setAttribute("aria-pressed", String(coloured));
    all.disabled = isClear(parts);
  });
  return element;
}

/** Whether a part is shown. @param {import("../state/picking.js").Picking} parts @param {number} part */
function isShown({ enabled, isolated, hidden, shown }, part) {
  return !enabled || shown.includes(part) || !(isolated || hidden.includes(part));
}

/** @param {Context} context @param {{ part: number, number: number, coloured: boolean }} what */
function row(context, { part, number, coloured }) {
  const parts = partsOf(context);
  const name = `Part ${part + 1}`;
  const box = h("input", {
    type: "checkbox",
    class: "row-switch",
    "aria-label": `${name} shown`,
    onchange: () => set(context, (box.checked ? undig : dig)(partsOf(context), part)),
  });
  box.checked = isShown(parts, part);
  const only = h(
    "button",
    {
      type: "button",
      class: "link",
      "aria-label": `Show ${name} only`,
      onclick: () => {
        context.store.seal();
        context.store.set({ filters: { parts: isolate([part]) } }, { undo: FLIGHT });
        void context.app.views.flyToShown();
      },
    },
    "only",
  );
  return h(
    "li",
    {},
    h("label", { class: "part-name" }, box, coloured && swatch(categoryColour("part", part)), name),
    h("span", { class: "category-count" }, counted(number, "cell")),
    only,
  );
}
