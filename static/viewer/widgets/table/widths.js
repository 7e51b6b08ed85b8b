import { h } from "../dom.js";
import { widestTexts } from "./columns.js";

/** @typedef {import("./columns.js").Column} Column */

/** Columns of words are no wider, in pixels: longer ones are cut, and told by the tooltip. */
const WIDEST = 160;

/**
 * Measure how wide the columns have to be. The rows themselves can't tell: most are not there, and the columns must not move when
 * others come.
 *
 * @param {HTMLElement} table in the page and shown, so that it has its font
 * @param {readonly Column[]} columns
 * @param {number} rows
 * @returns {number[]} pixels
 */
export function columnWidths(table, columns, rows) {
  const cells = columns.map((column) =>
    h(
      "div",
      { class: `data-table-cell data-table-${column.kind}` },
      h("div", { class: "data-table-name" }, column.name),
      ...widestTexts(column, rows).map((text) => h("div", {}, text)),
    ),
  );
  const ruler = h("div", { class: "data-table-ruler", "aria-hidden": "true" }, ...cells);
  table.append(ruler);
  const widths = cells.map((cell) => Math.min(WIDEST, Math.ceil(cell.getBoundingClientRect().width)));
  ruler.remove();
  return widths;
}

/** Columns as a grid has them: at least so wide, and where there is room in proportion. @param {readonly number[]} widths */
export function template(widths) {
  return widths.map((width) => `minmax(${width}px, ${width}fr)`).join(" ");
}
