import { BY_HAND, copyText } from "../input/copying.js";
import { h } from "../widgets/dom.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/**
 * Copies cells to the clipboard in a form that other programs take. The text stands on the page for a while, selected, so that it
 * can be copied by hand where the browser denies the clipboard.
 *
 * @param {Context} context @param {() => readonly number[]} cells rows @param {string} name of the set
 */
export function cellsCopied(context, cells, name) {
  const { list_forms: forms } = context.tables;
  const form = h(
    "select",
    { class: "choice" },
    ...forms.map((one) => h("option", { value: one.id }, one.name)),
  );
  const said = h("span", { class: "quiet", role: "status" });
  const text = h("textarea", {
    class: "copied-cells",
    rows: "3",
    readonly: true,
    hidden: true,
    "aria-label": "Copied cells",
  });
  const button = h(
    "button",
    {
      type: "button",
      class: "button",
      onclick: async () => {
        const written = await context.app.listCells(cells(), form.value, name);
        if (written === null) return;
        text.value = written;
        text.hidden = false;
        const copied = await copyText(written, () => text.select());
        said.textContent = copied ? "copied" : BY_HAND;
      },
    },
    "Copy",
  );
  return h(
    "div",
    { class: "copy-cells" },
    h(
      "div",
      { class: "copy-row" },
      h("label", { class: "copy-form" }, h("span", { class: "quiet" }, "Copy as"), form),
      button,
    ),
    said,
    text,
  );
}
