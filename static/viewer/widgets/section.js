import { freshId, h, setText } from "./dom.js";
import { watch } from "./bind.js";
import { choice, toggle } from "./choice.js";
import { actions, colours, numbers, text } from "./fields.js";
import { slider } from "./slider.js";

/**
 * @typedef {import("./bind.js").Context} Context @typedef {import("./bind.js").Control} Control
 *
 * @typedef {object} Section  a panel's table
 * @property {string} id
 * @property {string} title
 * @property {boolean} [open] whether it starts unfolded
 * @property {boolean} [openNarrow] the same where the screen is narrow, if that differs
 * @property {readonly Control[]} controls
 * @property {(context: Context) => string} [digest] what a folded section tells of itself
 * @property {import("./bind.js").Dependencies} [digestOf]
 * @property {(context: Context) => boolean} [hidden] whether there is nothing in it now
 * @property {import("./bind.js").Dependencies} [hiddenOf]
 */

/** @type {{ [Kind in Control["kind"]]: (context: Context, control: Extract<Control, { kind: Kind }>) => HTMLElement }} */
const WIDGETS = {
  slider,
  choice,
  toggle,
  colours,
  numbers,
  actions,
  text,
  more,
  custom: (context, control) => control.render(context),
};

/** @param {Context} context @param {Control} control @returns {HTMLElement} */
export function renderControl(context, control) {
  const widget = /** @type {(context: Context, control: Control) => HTMLElement} */ (WIDGETS[control.kind]);
  const element = widget(context, control);
  return control.more ? folding(context, element, control.more) : element;
}

/** A row, and below it the rows that its label unfolds. @param {Context} context @param {HTMLElement} head @param {readonly Control[]} rows @returns {HTMLElement} */
function folding(context, head, rows) {
  const label = /** @type {HTMLElement} */ (head.querySelector(".row-label"));
  const rest = h(
    "div",
    { class: "folded", id: freshId("folded"), hidden: true },
    ...rows.map((one) => renderControl(context, one)),
  );
  const button = h(
    "button",
    {
      type: "button",
      class: "row-label row-fold",
      "aria-expanded": "false",
      "aria-controls": rest.id,
      title: label.title,
      onclick: () => {
        rest.hidden = !rest.hidden;
        button.setAttribute("aria-expanded", String(!rest.hidden));
      },
    },
    label.textContent,
  );
  head
    .querySelector(`#${CSS.escape(label.getAttribute("for") ?? "")}`)
    ?.setAttribute("aria-label", label.textContent ?? "");
  label.replaceWith(button);
  return h("div", { class: "folding" }, head, rest);
}

const MEMORY = "hexalab.sections";

/** @returns {Record<string, boolean>} */
function remembered() {
  try {
    return JSON.parse(localStorage.getItem(MEMORY) ?? "{}") ?? {};
  } catch {
    return {};
  }
}

/** A fold that remembers whether it is open. @param {string} id @param {boolean} open @param {HTMLElement} summary @param {string} className */
function fold(id, open, summary, className) {
  const element = h(
    "details",
    { class: className, id: `section-${id}`, open: remembered()[id] ?? open },
    summary,
  );
  element.addEventListener("toggle", () => {
    try {
      localStorage.setItem(MEMORY, JSON.stringify({ ...remembered(), [id]: element.open }));
    } catch {
      // a browser that keeps nothing: the fold still folds
    }
  });
  return element;
}

/** @param {Context} context @param {Section} section */
export function renderSection(context, section) {
  const digest = h("span", { class: "digest" });
  const summary = h("summary", { class: "section-head" }, h("h2", {}, section.title), digest);
  const narrow = matchMedia("(max-width: 720px)").matches;
  const open = (narrow ? section.openNarrow : undefined) ?? section.open ?? false;
  const element = fold(section.id, open, summary, "section");
  element.append(
    h(
      "div",
      { class: "section-body" },
      ...section.controls.map((control) => renderControl(context, control)),
    ),
  );
  if (section.digest)
    watch(context, section.digestOf ?? {}, () => setText(digest, section.digest?.(context) ?? ""));
  const { hidden } = section;
  if (hidden) watch(context, section.hiddenOf ?? {}, () => void (element.hidden = hidden(context)));
  return element;
}

/** Controls that stay folded away until asked for. @param {Context} context @param {import("./bind.js").MoreControl} control */
function more(context, control) {
  const element = fold(control.id, false, h("summary", { class: "more-head" }, control.label), "more");
  element.append(...control.items.map((item) => renderControl(context, item)));
  return element;
}
