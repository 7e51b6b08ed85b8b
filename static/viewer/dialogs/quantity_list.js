import { quantityOf, quantityOptions } from "../state/quantity.js";
import { tracedOf } from "../state/tables.js";
import { h } from "../widgets/dom.js";

/** Which of the quantities a way to save lists: none; metrics and whole attributes; all that can be coloured by. @typedef {"none" | "whole" | "all"} Listed */

/** @type {Record<Listed, string>} */
const TITLES = { none: "", whole: "What each cell carries", all: "Colours to choose from" };

/** A component of an attribute: its number ends the id. */
const COMPONENT = /^(.*):\d+$/;

/** All that is traced, which cells carry together. */
export const STRUCTURE = { value: "structure", name: "Structure: sheets, chords, block, distance" };

/** What a vector's name has behind it in lists of numbers. */
const MAGNITUDE = /, magnitude$/;

/**
 * Quantities to tick. When the dialog opens, what is looked at is ticked; of what cells carry, all attributes of the file are, too.
 *
 * @param {import("../widgets/bind.js").Context} context
 */
export function quantityList(context) {
  const legend = h("legend", {});
  const list = h("div", { class: "save-quantities" });
  const element = h("fieldset", { class: "save-list" }, legend, list);
  /** @type {Record<Listed, Set<string>>} */
  let ticked = { none: new Set(), whole: new Set(), all: new Set() };

  /** @param {Listed} listed */
  function options(listed) {
    const rows = quantityOptions(context);
    if (listed === "all") return rows;
    const ids = new Set(rows.map(({ value }) => value));
    const whole = rows.filter(
      ({ value }) => !ids.has(COMPONENT.exec(value)?.[1] ?? "") && !tracedOf(context.tables, value),
    );
    return [...whole.map(({ value, name }) => ({ value, name: name.replace(MAGNITUDE, "") })), STRUCTURE];
  }

  return {
    element,
    begin() {
      const attributes = (context.facts.get("summary")?.attributes ?? []).map(({ id }) => id);
      const { id } = quantityOf(context);
      const looked = tracedOf(context.tables, id) ? STRUCTURE.value : id;
      ticked = { none: new Set(), whole: new Set([looked, ...attributes]), all: new Set([id]) };
    },
    /** @param {Listed} listed */
    show(listed) {
      element.hidden = listed === "none";
      if (element.hidden) return;
      legend.textContent = TITLES[listed];
      list.replaceChildren(...options(listed).map(({ value, name }) => row(value, name, ticked[listed])));
    },
    /** @param {Listed} listed @returns {string[]} */
    chosen(listed) {
      if (listed === "none") return [];
      return options(listed)
        .map(({ value }) => value)
        .filter((id) => ticked[listed].has(id));
    },
  };

  /** @param {string} id @param {string} name @param {Set<string>} among */
  function row(id, name, among) {
    const box = h("input", {
      type: "checkbox",
      value: id,
      checked: among.has(id),
      onchange: () => void (box.checked ? among.add(id) : among.delete(id)),
    });
    return h("label", { class: "check" }, box, h("span", {}, name));
  }
}
