import { freshId, h, setAttribute } from "./dom.js";
import { Head } from "./table/head.js";
import { placeByKey, wayOfClick, wayOfKey } from "./table/keys.js";
import { placesOf, sorted, unsorted } from "./table/order.js";
import { RowChoice } from "./table/row_choice.js";
import { Rows } from "./table/rows.js";
import { isInSight, rowsToDraw, topToCentre, topToReach } from "./table/sight.js";
import { columnWidths, template } from "./table/widths.js";

/**
 * @typedef {import("./table/columns.js").Column} Column
 *
 * @typedef {object} Options
 * @property {string} label for screen readers
 * @property {(ids: number[]) => void} choose the chosen rows are others now; in the order in which they were chosen
 * @property {(id: number) => void} [activate] a row was meant with emphasis: Enter, a double click
 */

/**
 * A table of up to some 100,000 rows, of which those in sight are in the page. Columns sort when their heads are clicked; rows are
 * chosen by click, Ctrl-click and Shift-click, or by arrow keys. A row's id is its number in the columns, wherever it stands.
 *
 *     const table = new DataTable({ label: "Sheets", choose: highlight, activate: zoomTo });
 *     panel.append(table.element);
 *     table.show([{ id: "number", name: "Sheet", kind: "number", values: numbers }], numbers.length);
 *     table.mark([17]);
 */
export class DataTable {
  #head = new Head((column) => this.#sort(column));
  #rows;
  #choice = new RowChoice();
  #options;

  /** @type {readonly Column[]} */
  #columns = [];

  /** The row at each place. @type {Uint32Array} */
  #order = unsorted(0);

  /** The place of each row. @type {Uint32Array} */
  #places = unsorted(0);

  /** @type {{ column: string, descending: boolean } | null} */
  #sortedBy = null;

  /** How far it is scrolled: a browser may forget it while the table is hidden. */
  #top = 0;

  /** A place that is to be brought into sight as soon as the table is shown. @type {number | null} */
  #wanted = null;

  #rowHeight = 0;
  #measured = false;

  /** The table; its style sheet says how high it may be. @type {HTMLElement} */
  element;

  /** @param {Options} options */
  constructor(options) {
    this.#options = options;
    this.#rows = new Rows(freshId("row"));
    this.element = h(
      "div",
      {
        class: "data-table",
        role: "grid",
        tabindex: 0,
        "aria-label": options.label,
        "aria-multiselectable": "true",
        onscroll: () => this.#scrolled(),
        onkeydown: (/** @type {KeyboardEvent} */ event) => this.#key(event),
      },
      this.#head.element,
      this.#rows.element,
    );
    this.#rows.element.addEventListener("click", (event) => this.#click(event));
    this.#rows.element.addEventListener("dblclick", () => this.#activate());
    new ResizeObserver(() => this.#fit()).observe(this.element);
  }

  /**
   * Show a table. Where it has the same columns and as many rows as the one before, it is taken for the same: what is chosen, the
   * order and the place stay.
   *
   * @param {readonly Column[]} columns the first one names the row; it stays in sight
   * @param {number} count of the rows
   */
  show(columns, count) {
    const alike = columns.map(({ id }) => id).join() === this.#columns.map(({ id }) => id).join();
    const same = alike && count === this.#order.length;
    this.#columns = columns;
    if (!alike) this.#sortedBy = null;
    if (!same) {
      this.#choice = new RowChoice();
      this.#order = unsorted(count);
      this.#top = 0;
      this.#wanted = null;
    }
    setAttribute(this.element, "aria-rowcount", count + 1);
    this.#rows.element.hidden = !count; // a group of rows without a row is none
    this.#head.show(columns);
    this.#rows.show(columns);
    this.#measured = false;
    this.#arrange();
    this.#fit();
  }

  /**
   * Choose rows from outside: nobody is called. The first of them, as the table is sorted, is brought into sight.
   *
   * @param {readonly number[]} ids
   */
  mark(ids) {
    const there = ids.filter((id) => id in this.#places);
    if (this.#choice.is(there)) return;
    const place = there.reduce((first, id) => Math.min(first, this.#places[id]), Infinity);
    this.#choice.set(there, there.length ? this.#order[place] : null);
    this.#wanted = there.length ? place : null;
    this.#reach();
    this.#draw();
  }

  /** What is seen of the rows. @returns {import("./table/sight.js").Sight} */
  get #sight() {
    const height = Math.max(0, this.element.clientHeight - this.#head.element.offsetHeight);
    return { top: this.#top, height, row: this.#rowHeight, rows: this.#order.length };
  }

  /** Sort, by the column and the way that are chosen. */
  #arrange() {
    const column = this.#columns.find(({ id }) => id === this.#sortedBy?.column);
    if (column) this.#order = sorted(this.#order, column, this.#sortedBy?.descending ?? false);
    this.#places = placesOf(this.#order);
    this.#head.mark(this.#sortedBy);
  }

  /** @param {string} column */
  #sort(column) {
    const again = this.#sortedBy?.column === column;
    this.#sortedBy = { column, descending: again && !this.#sortedBy?.descending };
    this.#arrange();
    this.#scrollTo(0); // what comes first is what was asked for
    this.#draw();
  }

  /** Measure what only a shown table has: the height of a row, the widths of the columns; then draw. */
  #fit() {
    const { element } = this;
    if (!element.clientHeight || !this.#columns.length) return;
    if (!this.#measured) {
      const widths = columnWidths(element, this.#columns, this.#order.length);
      element.style.setProperty("--columns", template(widths));
      element.style.setProperty("--least", `${widths.reduce((sum, width) => sum + width, 0)}px`);
      this.#measured = true;
    }
    this.#rowHeight = this.#head.element.offsetHeight;
    this.#rows.element.style.height = `${this.#order.length * this.#rowHeight}px`;
    this.#scrollTo(this.#top);
    this.#reach();
    this.#draw();
  }

  #reach() {
    if (this.#wanted === null || !this.element.clientHeight) return;
    if (!isInSight(this.#wanted, this.#sight)) this.#scrollTo(topToCentre(this.#wanted, this.#sight));
    this.#wanted = null;
  }

  #draw() {
    const [first, end] = rowsToDraw(this.#sight);
    this.#rows.element.style.paddingTop = `${first * this.#rowHeight}px`;
    this.#rows.draw(first, end, this.#order, this.#choice);
    const cursor = this.#cursor;
    setAttribute(this.element, "aria-activedescendant", cursor === null ? null : this.#rows.idAt(cursor));
  }

  #scrolled() {
    if (!this.element.clientHeight) return;
    this.#top = this.element.scrollTop;
    this.#draw();
  }

  /** @param {number} top */
  #scrollTo(top) {
    this.#top = top;
    if (!this.element.clientHeight) return;
    this.element.scrollTop = top;
    this.#top = this.element.scrollTop; // it may have come to the end
  }

  /** @param {MouseEvent} event */
  #click(event) {
    const place = this.#rows.placeOf(event.target);
    if (place !== null) this.#take(place, wayOfClick(event));
  }

  /** Choose by hand. @param {number} place @param {import("./table/row_choice.js").Way} way */
  #take(place, way) {
    this.#choice.take(this.#order[place], way, this.#order, this.#places);
    this.#draw();
    if (way !== "move") this.#options.choose(this.#choice.ids);
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.target !== this.element) return; // a button of the head
    const place = placeByKey(event, this.#cursor, this.#sight);
    if (place !== null) {
      this.#scrollTo(topToReach(place, this.#sight));
      this.#take(place, wayOfKey(event));
    } else if (!this.#keys[event.key]?.()) return;
    event.preventDefault();
  }

  /** The place of the cursor. */
  get #cursor() {
    const { cursor } = this.#choice;
    return cursor === null ? null : this.#places[cursor];
  }

  /** Keys that lead nowhere: whether there was something for them to do. @type {Record<string, () => boolean>} */
  #keys = {
    " ": () => this.#toggle(),
    Enter: () => this.#activate(),
    Escape: () => this.#clear(),
  };

  #toggle() {
    const place = this.#cursor;
    if (place !== null) this.#take(place, "toggle");
    return true; // else the table would be scrolled
  }

  #activate() {
    const { cursor } = this.#choice;
    if (cursor !== null) this.#options.activate?.(cursor);
    return cursor !== null;
  }

  #clear() {
    if (!this.#choice.size) return false;
    this.#choice.clear();
    this.#draw();
    this.#options.choose([]);
    return true;
  }
}
