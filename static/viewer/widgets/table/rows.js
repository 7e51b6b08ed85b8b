import { h, setAttribute, setText } from "../dom.js";
import { textOf } from "./columns.js";

/**
 * @typedef {import("./columns.js").Column} Column @typedef {import("./row_choice.js").RowChoice} RowChoice
 *
 * @typedef {object} Line  an element that shows one row now, another one later
 * @property {HTMLElement} element
 * @property {HTMLElement[]} cells
 * @property {number} row the one that it shows; -1: none yet
 */

/** What is put into a cell, by the column's kind. @type {Record<Column["kind"], (cell: HTMLElement, text: string) => void>} */
const FILL = {
  number: setText,
  word(cell, text) {
    setText(cell, text);
    cell.title = text;
  },
  flag(cell, text) {
    if (text === cell.textContent) return;
    cell.replaceChildren(...(text ? [h("span", { class: "visually-hidden" }, text)] : []));
    cell.classList.toggle("data-table-yes", text !== "");
  },
};

/** The rows in sight: as many elements as have room, which are filled anew when the table is scrolled. */
export class Rows {
  element = h("div", { class: "data-table-body", role: "rowgroup" });
  #stem;

  /** @type {readonly Column[]} */
  #columns = [];

  /** @type {Line[]} */
  #lines = [];

  #first = 0;

  /** @param {string} stem of the rows' ids */
  constructor(stem) {
    this.#stem = stem;
  }

  /** @param {readonly Column[]} columns */
  show(columns) {
    this.#columns = columns;
    this.#lines = [];
    this.element.replaceChildren();
  }

  /** Give the rows from one place to before another. @param {number} first @param {number} end @param {Uint32Array} order @param {RowChoice} choice */
  draw(first, end, order, choice) {
    this.#first = first;
    while (this.#lines.length < end - first) this.#lines.push(this.#line());
    for (const line of this.#lines.splice(end - first)) line.element.remove();
    this.#lines.forEach((line, k) => this.#fill(line, order[first + k], first + k, choice));
  }

  /** Id of the element that shows a place; null where none does. @param {number} place */
  idAt(place) {
    return this.#lines[place - this.#first]?.element.id ?? null;
  }

  /** The place that an element shows, or what lies in it; null where it shows none. @param {EventTarget | null} target */
  placeOf(target) {
    const at = this.#lines.findIndex(({ element }) => element.contains(/** @type {Node | null} */ (target)));
    return at < 0 ? null : this.#first + at;
  }

  /** @returns {Line} */
  #line() {
    const cells = this.#columns.map(({ kind }, k) =>
      h("div", { class: `data-table-cell data-table-${kind}`, role: k ? "gridcell" : "rowheader" }),
    );
    const element = h("div", { class: "data-table-row", role: "row" }, ...cells);
    this.element.append(element);
    return { element, cells, row: -1 };
  }

  /** @param {Line} line @param {number} row @param {number} place @param {RowChoice} choice */
  #fill(line, row, place, choice) {
    const { element, cells } = line;
    setAttribute(element, "aria-rowindex", place + 2); // the head is the first
    setAttribute(element, "aria-selected", String(choice.has(row)));
    element.classList.toggle("data-table-cursor", row === choice.cursor);
    if (line.row === row) return;
    line.row = row;
    element.id = `${this.#stem}-${row}`;
    cells.forEach((cell, k) => FILL[this.#columns[k].kind](cell, textOf(this.#columns[k], row)));
  }
}
