import { h } from "./dom.js";

/** A square of a colour, beside the words of what it stands for. @param {string} colour */
export function swatch(colour) {
  const element = h("span", { class: "category", "aria-hidden": "true" });
  element.style.background = colour; // an attribute would be an inline style, which the page's policy forbids
  return element;
}
