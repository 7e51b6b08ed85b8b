import { categoryColour } from "../colours/palettes.js";
import { groupName } from "../state/groups.js";
import { count } from "../state/numbers.js";
import { h } from "../widgets/dom.js";
import { swatch } from "../widgets/swatch.js";

/**
 * @typedef {Omit<import("../state/answers.js").GroupRow, "kind">} GroupRow  of cells, of nodes, of features
 *
 * @typedef {object} Press  what is done when a row is used
 * @property {string} label of the box, behind the group's name
 * @property {(group: GroupRow, on: boolean) => void} turn
 * @property {(group: GroupRow) => void} [only]
 */

/**
 * Rows of groups, each with a box. They are made once for a mesh and then kept: a thousand that were made anew at every click
 * would be felt, and would lose the focus.
 */
export class GroupRows {
  element = h("ul", { class: "parts" });
  #rows;

  /** @param {readonly GroupRow[]} groups @param {Press} press */
  constructor(groups, press) {
    this.#rows = groups.map((group) => row(group, press));
    this.element.append(...this.#rows.map((one) => one.element));
  }

  /**
   * @param {(group: GroupRow) => boolean} isOn
   * @param {(group: GroupRow) => string | null} colourOf as a style sheet has it; null: none
   */
  update(isOn, colourOf) {
    for (const { group, box, square } of this.#rows) {
      box.checked = isOn(group);
      const colour = colourOf(group);
      square.hidden = colour === null;
      if (colour !== null) square.style.background = colour;
    }
  }

  /** Leave the rows whose names have a text in them. @param {string} text @returns {number} how many these are */
  find(text) {
    const wanted = text.trim().toLowerCase();
    let left = 0;
    for (const { group, element } of this.#rows) {
      element.hidden = !groupName(group).toLowerCase().includes(wanted);
      if (!element.hidden) left++;
    }
    this.element.hidden = !left;
    return left;
  }
}

/** @param {number} colour its number in the palette of groups */
export const groupColour = (colour) => categoryColour("group", colour);

/** @param {GroupRow} group @param {Press} press */
function row(group, { label, turn, only }) {
  const name = groupName(group);
  const empty = group.count === 0;
  const title = empty ? `${name}: it has no members` : name;
  const box = h("input", {
    type: "checkbox",
    class: "row-switch",
    "aria-label": `${name} ${label}`,
    disabled: empty,
    onchange: () => turn(group, box.checked),
  });
  const square = swatch("none");
  square.hidden = true;
  const element = h(
    "li",
    empty ? { class: "idle-group" } : {},
    h("label", { class: "part-name", title }, box, square, h("span", { class: "group-name" }, name)),
    h("span", { class: "category-count" }, count(group.count)),
    only &&
      h(
        "button",
        {
          type: "button",
          class: "link",
          "aria-label": `Show ${name} only`,
          disabled: empty,
          onclick: () => only(group),
        },
        "only",
      ),
  );
  return { group, element, box, square };
}
