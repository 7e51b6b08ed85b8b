/**
 * The numbers that a file gives its cells (SPEC R11), and back from numbers to rows. A file that gives none counts its rows on.
 */
export class Numbering {
  #first;
  #cells;
  /** Rows in the order of their numbers. @type {Uint32Array | null} */
  #order = null;

  /** @param {Pick<import("./answers.js").Numbers, "first" | "cells">} numbers */
  constructor({ first, cells }) {
    this.#first = first;
    this.#cells = cells;
  }

  /** The number of a row. @param {number} row */
  of(row) {
    return this.#cells ? this.#cells[row] : row + this.#first;
  }

  /**
   * The rows whose numbers are between two, both included; in the order of their numbers.
   *
   * @param {number} low @param {number} high @param {number} count cells of the mesh
   * @returns {number[]}
   */
  between(low, high, count) {
    const cells = this.#cells;
    const rows = [];
    if (!cells) {
      const [from, to] = [Math.max(0, low - this.#first), Math.min(count - 1, high - this.#first)];
      for (let row = from; row <= to; row++) rows.push(row);
      return rows;
    }
    const order = this.#sorted(cells);
    for (let place = firstNotBelow(order, cells, low); place < order.length; place++) {
      if (cells[order[place]] > high) break;
      rows.push(order[place]);
    }
    return rows;
  }

  /** The smallest and the largest number. @param {number} count cells of the mesh @returns {[number, number]} */
  ends(count) {
    const cells = this.#cells;
    if (!cells?.length) return [this.#first, this.#first + count - 1];
    const order = this.#sorted(cells);
    return [cells[order[0]], cells[order[order.length - 1]]];
  }

  /** @param {Int32Array | Float64Array} cells */
  #sorted(cells) {
    this.#order ??= Uint32Array.from(cells, (_, row) => row).sort((a, b) => cells[a] - cells[b]);
    return this.#order;
  }
}

/** Rows counted from 0: before anything is known of a file. */
export const ROWS = new Numbering({ first: 0, cells: null });

/** @param {Uint32Array} order @param {Int32Array | Float64Array} cells @param {number} number */
function firstNotBelow(order, cells, number) {
  let [low, high] = [0, order.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (cells[order[middle]] < number) low = middle + 1;
    else high = middle;
  }
  return low;
}
