import { count, decimal } from "../state/numbers.js";
import { quantityOf } from "../state/quantity.js";
import { titled, unitOf } from "../state/units.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { cellsCopied } from "./cells_copied.js";

/** @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../state/answers.js").Worst} Worst */

/** So many cells without a finite value are named. */
const NAMED = 20;

/** Cells without a finite value. @param {Context} context */
const total = (context) => context.facts.get("statistics")[quantityOf(context).id]?.not_finite ?? 0;

/**
 * The worst cells (Q3): number, value, place. A click, or the arrow keys, flies to a cell, which is outlined. Cells without a
 * finite value have no order: they are a group of their own.
 *
 * @param {Context} context
 */
export function worstCells(context) {
  const caption = h("caption");
  const headings = ["Cell", "Value", "Place"].map((name) => h("th", { scope: "col" }, name));
  const body = h("tbody", { onkeydown: (/** @type {KeyboardEvent} */ event) => walk(event, body) });
  const table = h("table", { class: "table worst" }, caption, h("thead", {}, h("tr", {}, ...headings)), body);
  const others = h("p", {
    class: "cell-list",
    onkeydown: (/** @type {KeyboardEvent} */ event) => walk(event, others),
  });
  const save = h(
    "div",
    { class: "actions" },
    h("button", { type: "button", class: "button", onclick: () => context.app.saveWorst() }, "List as CSV"),
    h(
      "button",
      { type: "button", class: "button", onclick: () => context.app.saveValues() },
      "All values as CSV",
    ),
  );
  const copied = cellsCopied(context, () => context.facts.get("worst")?.cells ?? [], "WORST");
  const element = h(
    "div",
    { class: "worst-cells" },
    h("div", { class: "worst-rows" }, table),
    others,
    save,
    copied,
  );
  watch(context, { status: ["unit"], facts: ["worst", "cell", "summary", "numbering"] }, () => {
    const worst = context.facts.get("worst");
    element.hidden = !worst;
    if (!worst) return;
    const { attribute, name, unit } = quantityOf(context);
    headings[1].textContent = titled("Value", unit);
    headings[2].textContent = titled("Place", unitOf(context.store.status, 1));
    caption.textContent = `${attribute ? "Highest" : "Worst"} cells by ${name}`;
    const inspected = context.facts.get("cell")?.cell;
    const focused = body.contains(document.activeElement) || others.contains(document.activeElement);
    body.replaceChildren(
      ...worst.cells.map((cell, row) =>
        line(context, cell, inspected, [
          decimal(worst.values[row]),
          worst.places[row].map((place) => decimal(place)).join(" "),
        ]),
      ),
    );
    others.replaceChildren(
      h("span", { class: "quiet" }, `Without a finite value (${count(total(context))}) `),
      ...worst.not_finite.slice(0, NAMED).map((cell) => link(context, cell, inspected)),
    );
    table.hidden = !worst.cells.length;
    others.hidden = !worst.not_finite.length;
    if (focused) /** @type {HTMLElement | null} */ (element.querySelector("button[aria-current]"))?.focus();
  });
  return element;
}

/** @param {Context} context @param {number} cell @param {number | undefined} inspected @param {string[]} words */
function line(context, cell, inspected, words) {
  return h(
    "tr",
    {},
    h("th", { scope: "row" }, link(context, cell, inspected)),
    ...words.map((word) => h("td", {}, word)),
  );
}

/** @param {Context} context @param {number} cell @param {number | undefined} inspected */
function link(context, cell, inspected) {
  const attributes = {
    type: "button",
    class: "link",
    title: "Fly to this cell",
    ...(cell === inspected ? { "aria-current": "true" } : {}),
    onclick: () => void context.app.flyTo(cell),
  };
  return h("button", attributes, String(context.facts.get("numbering").of(cell)));
}

/** Arrow keys go from cell to cell. @param {KeyboardEvent} event @param {HTMLElement} body */
function walk(event, body) {
  const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  if (!step) return;
  event.preventDefault();
  event.stopPropagation();
  const buttons = [...body.querySelectorAll("button")];
  const at = buttons.indexOf(/** @type {HTMLButtonElement} */ (document.activeElement));
  const next = buttons[Math.min(buttons.length - 1, Math.max(0, at + step))];
  next?.focus();
  next?.click();
}
