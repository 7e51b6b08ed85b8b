import { quantityOf, quantityOptions } from "../state/quantity.js";
import { h } from "../widgets/dom.js";

/** Which of the quantities a way to save lists: none; metrics and whole attributes; all that can be coloured by. @typedef {"none" | "whole" | "all"} Listed */

/** @type {Record<Listed, string>} */
const TITLES = { none: "", whole: "What each cell carries", all: "Colours to choose from" };

/** A component of an attribute: its number ends the id. */
const COMPONENT = /^(.*):\d+$/;

/**
 * Quantities to tick. What is looked at is ticked when the dialog opens, and the file's attributes.
 *
 * @param {import("../widgets/bind.js").Context} context
 */
export function quantityList(context) {
  const legend = h("legend", {});
  const list = h("div", { class: "save-quantities" });
  const element = h("fieldset", { class: "save-list" }, legend, list);
  /** @type {Set<string>} */
  let ticked = new Set();

  /** @param {Listed} listed */
  function options(listed) {
    const rows = quantityOptions(context);
    if (listed === "all") return rows;
    const ids = new Set(rows.map(({ value }) => value));
    return rows.filter(({ value }) => !ids.has(COMPONENT.exec(value)?.[1] ?? ""));
  }

  return {
    element,
    begin() {
      const attributes = (context.facts.get("summary")?.attributes ?? []).map(({ id }) => id);
      ticked = new Set([quantityOf(context).id, ...attributes]);
    },
    /** @param {Listed} listed */
    show(listed) {
      element.hidden = listed === "none";
      if (element.hidden) return;
      legend.textContent = TITLES[listed];
      list.replaceChildren(...options(listed).map(({ value, name }) => row(value, name)));
    },
    chosen: () => [...ticked],
  };

  /** @param {string} id @param {string} name */
  function row(id, name) {
    const box = h("input", {
      type: "checkbox",
      value: id,
      checked: ticked.has(id),
      onchange: () => void (box.checked ? ticked.add(id) : ticked.delete(id)),
    });
    return h("label", { class: "check" }, box, h("span", {}, name));
  }
}
