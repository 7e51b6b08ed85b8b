import { h, setAttribute } from "../dom.js";

/** @typedef {import("./columns.js").Column} Column */

/** Where a key leads among the buttons of the head. @type {Record<string, (at: number, last: number) => number>} */
const STEPS = {
  ArrowRight: (at, last) => Math.min(last, at + 1),
  ArrowLeft: (at) => Math.max(0, at - 1),
  Home: () => 0,
  End: (_, last) => last,
};

/** The head of a table: a button for each column that sorts by it. All are one stop of the Tab key, arrows go along them. */
export class Head {
  #line = h("div", { class: "data-table-row", role: "row", "aria-rowindex": 1 });
  element = h("div", { class: "data-table-head", role: "rowgroup" }, this.#line);
  #sort;

  /** @type {{ id: string, cell: HTMLElement, button: HTMLButtonElement }[]} */
  #cells = [];

  /** @param {(column: string) => void} sort a column was clicked */
  constructor(sort) {
    this.#sort = sort;
    this.element.addEventListener("keydown", (event) => this.#walk(event));
  }

  /** @param {readonly Column[]} columns */
  show(columns) {
    const focused = this.#cells.find(({ button }) => button === document.activeElement)?.id;
    this.#cells = columns.map(({ id, name, hint, kind }, k) => {
      const button = h(
        "button",
        { type: "button", title: hint, tabindex: k ? -1 : 0, onclick: () => this.#press(id) },
        h("span", { class: "data-table-name" }, name),
      );
      const cell = h("div", { class: `data-table-cell data-table-${kind}`, role: "columnheader" }, button);
      return { id, cell, button };
    });
    this.#line.replaceChildren(...this.#cells.map(({ cell }) => cell));
    this.#cells.find(({ id }) => id === focused)?.button.focus();
  }

  /** Tell by which column the table is sorted. @param {{ column: string, descending: boolean } | null} by */
  mark(by) {
    const way = by?.descending ? "descending" : "ascending";
    for (const { id, cell } of this.#cells) setAttribute(cell, "aria-sort", id === by?.column ? way : null);
  }

  /** @param {string} column */
  #press(column) {
    for (const { id, button } of this.#cells) button.tabIndex = id === column ? 0 : -1;
    this.#sort(column);
  }

  /** @param {KeyboardEvent} event */
  #walk(event) {
    const at = this.#cells.findIndex(({ button }) => button === document.activeElement);
    const step = STEPS[event.key];
    if (!step || at < 0) return;
    event.preventDefault();
    const next = step(at, this.#cells.length - 1);
    this.#cells[at].button.tabIndex = -1;
    this.#cells[next].button.tabIndex = 0;
    this.#cells[next].button.focus();
  }
}
