import { freshId, h, setText } from "./dom.js";
import { foot } from "./matrix/foot.js";
import { listen } from "./matrix/hand.js";
import { outlinedPlaces } from "./matrix/outlined.js";
import { Painter } from "./matrix/painter.js";
import { PairIndex } from "./matrix/pair_index.js";
import {
  dragged,
  isWhole,
  leadsSomewhere,
  placeUnder,
  pointOf,
  reaching,
  whole,
  zoomed,
} from "./matrix/window.js";
import { meetingInWords } from "./matrix/words.js";
import { followPixelRatio } from "./pixel_ratio.js";

/**
 * @typedef {import("./matrix/pair_index.js").Pairs} Pairs @typedef {import("./matrix/pair_index.js").Place} Place
 * @typedef {import("./matrix/window.js").Point} Point
 *
 * @typedef {object} Options
 * @property {string} label for screen readers
 * @property {import("./matrix/words.js").Kind} kind what the things are called: ["sheet", "sheets"]
 * @property {(a: number, b: number) => void} choose a pair was clicked, whether they meet or not; the same twice on the diagonal
 * @property {(thing: number) => string} [name] its number on the screen
 */

/** A press of a button or key leads nearer by this factor. */
const STEP = 2;

/** A hand means the pair nearest to it, as far as this in pixels, where cells are too small to be hit. */
const REACH = 3;

/** The middle of the window. */
const MIDDLE = { x: 0.5, y: 0.5 };

/** Where an arrow leads. @type {Record<string, readonly [rows: -1 | 0 | 1, columns: -1 | 0 | 1]>} */
const ARROWS = { ArrowUp: [-1, 0], ArrowDown: [1, 0], ArrowLeft: [0, -1], ArrowRight: [0, 1] };

/**
 * Which of n things meet: a square of n rows and n columns, each pair a cell on both sides of the diagonal. Quick with thousands
 * of things and a million pairs.
 *
 *     const matrix = new PairMatrix({ label: "Sheets that meet", kind: ["sheet", "sheets"], choose: showTwo });
 *     panel.append(matrix.element);
 *     matrix.show({ count: 3, one: [0, 0], other: [1, 2], crossings: [24, 0], beside: [0, 12] });
 *     matrix.mark([0, 1]);
 */
export class PairMatrix {
  #options;
  #canvas;
  #painter;
  #line = h("p", { class: "pair-matrix-line", role: "status" });

  /** @type {Pairs} */
  #pairs = { count: 0, one: [], other: [], crossings: [], beside: [] };
  #index = new PairIndex(this.#pairs);
  #window = whole(0);

  /** @type {readonly number[]} */
  #marked = [];

  /** Where the keyboard is, and where the hand is. @type {Place} */
  #cursor = { row: 0, column: 0 };
  /** @type {Place | null} */
  #hover = null;

  /** A frame that is asked for, and whether the cells have to be drawn anew in it. */
  #asked = false;
  #stale = false;

  /** @type {HTMLElement} */
  element;

  /** @param {Options} options */
  constructor(options) {
    this.#options = options;
    const hint = h(
      "p",
      { class: "visually-hidden", id: freshId("matrix-keys") },
      "Arrows move, with Shift to the next pair; Enter chooses; plus, minus and Home zoom.",
    );
    this.#canvas = h("canvas", {
      class: "pair-matrix-canvas",
      role: "application", // the arrow keys are its own
      tabindex: 0,
      "aria-label": options.label,
      "aria-describedby": hint.id,
      onkeydown: (/** @type {KeyboardEvent} */ event) => this.#key(event),
      onfocus: () => this.#ask(),
      onblur: () => this.#ask(),
    });
    this.#painter = new Painter(this.#canvas);
    const zoom = {
      nearer: () => this.#zoom(STEP, MIDDLE),
      further: () => this.#zoom(1 / STEP, MIDDLE),
      whole: () => this.#look(whole(this.#pairs.count)),
    };
    this.element = h(
      "div",
      { class: "pair-matrix", hidden: true },
      this.#canvas,
      hint,
      foot(zoom),
      this.#line,
    );
    this.#listen();
  }

  #listen() {
    listen(this.#canvas, {
      canZoom: (factor) => leadsSomewhere(this.#window, factor, this.#pairs.count),
      zoom: (factor, point) => this.#zoom(factor, point),
      drag: (by) => this.#look(dragged(this.#window, by, this.#pairs.count)),
      click: (point) => this.#choose(this.#meant(point)),
      hover: (point) => this.#point(point),
    });
    const fit = () => this.#painter.fit() && this.#ask(true);
    new ResizeObserver(fit).observe(this.#canvas);
    followPixelRatio(fit);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#ask(true));
  }

  /** Show pairs. Where there are as many things as before, the window stays. @param {Pairs} pairs */
  show(pairs) {
    const same = pairs.count === this.#pairs.count;
    this.#pairs = pairs;
    this.#index = new PairIndex(pairs);
    this.element.hidden = pairs.count === 0;
    this.#hover = null;
    if (!same) {
      this.#look(whole(pairs.count));
      this.#marked = [];
      this.#cursor = { row: 0, column: 0 };
    }
    this.#painter.fit();
    this.#ask(true);
  }

  /** Tint the rows and columns of things, and outline the pairs of a few. @param {readonly number[]} ids */
  mark(ids) {
    this.#marked = [...new Set(ids)].filter((id) => id >= 0 && id < this.#pairs.count);
    const chosen = this.#chosen;
    if (chosen) {
      if (!isMirrored(chosen, this.#cursor)) this.#cursor = chosen;
      this.#look(reaching(this.#window, this.#cursor, this.#pairs.count));
    }
    this.#ask();
  }

  /** The place that the keyboard is at, while it is shown. */
  get #keyPlace() {
    return this.#canvas.matches(":focus-visible") ? this.#cursor : null;
  }

  /** The pair that was chosen. @returns {Place | null} */
  get #chosen() {
    const [row, column = row, ...more] = this.#marked;
    return row === undefined || more.length ? null : { row, column };
  }

  /** @param {import("./matrix/window.js").Window} window */
  #look(window) {
    const { x, y, size } = this.#window;
    if (window.x === x && window.y === y && window.size === size) return;
    this.#window = window;
    this.#canvas.classList.toggle("pair-matrix-near", !isWhole(window, this.#pairs.count));
    this.#ask(true);
  }

  /** @param {number} factor @param {Point} point */
  #zoom(factor, point) {
    this.#look(zoomed(this.#window, factor, point, this.#pairs.count));
  }

  /** The cell that a hand means: where cells are small, the pair nearest to it. @param {Point} point */
  #meant(point) {
    const place = placeUnder(this.#window, point, this.#pairs.count);
    const reach = Math.floor((REACH * this.#window.size) / this.#canvas.clientWidth);
    return (reach && this.#index.nearest(place, reach)) || place;
  }

  /** @param {Point | null} point */
  #point(point) {
    this.#hover = point && this.#meant(point);
    this.#ask();
  }

  /** @param {Place} place */
  #choose(place) {
    this.#cursor = place;
    this.#options.choose(place.row, place.column);
    this.#ask();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const arrow = ARROWS[event.key];
    if (arrow) this.#move(arrow, event.shiftKey);
    else if (!this.#keys[event.key]) return;
    else this.#keys[event.key]();
    event.preventDefault();
  }

  /** @type {Record<string, () => void>} */
  #keys = {
    Enter: () => this.#choose(this.#cursor),
    " ": () => this.#choose(this.#cursor),
    "+": () => this.#zoom(STEP, pointOf(this.#window, this.#cursor)),
    "=": () => this.#zoom(STEP, pointOf(this.#window, this.#cursor)),
    "-": () => this.#zoom(1 / STEP, pointOf(this.#window, this.#cursor)),
    Home: () => this.#look(whole(this.#pairs.count)),
  };

  /** @param {readonly [rows: -1 | 0 | 1, columns: -1 | 0 | 1]} arrow @param {boolean} toPair to the next pair that meets */
  #move([rows, columns], toPair) {
    const { row, column } = this.#cursor;
    const kept = (/** @type {number} */ thing) => Math.max(0, Math.min(this.#pairs.count - 1, thing));
    const next = (/** @type {Place} */ place, /** @type {-1 | 0 | 1} */ step) =>
      step && toPair ? this.#index.nextInRow(place, step) : kept(place.column + step);
    const mirror = { row: column, column: row };
    this.#cursor = { row: next(mirror, rows), column: next({ row, column }, columns) };
    this.#hover = null;
    this.#look(reaching(this.#window, this.#cursor, this.#pairs.count));
    this.#ask();
  }

  /** Draw in the next frame. @param {boolean} [stale] the cells too */
  #ask(stale = false) {
    this.#stale ||= stale;
    if (this.#asked) return;
    this.#asked = true;
    requestAnimationFrame(() => this.#draw());
  }

  #draw() {
    this.#asked = false;
    if (!this.#pairs.count) return;
    const cursor = this.#hover ?? this.#keyPlace;
    const told = cursor ?? this.#chosen;
    setText(this.#line, told ? this.#words(told) : "");
    if (this.#stale) this.#painter.drawCells(this.#index, this.#window);
    this.#stale = false;
    const outlined = outlinedPlaces(this.#marked, this.#index);
    this.#painter.draw(this.#window, { things: this.#marked, outlined, cursor });
  }

  /** @param {Place} place */
  #words(place) {
    const { name = String, kind } = this.#options;
    const pair = this.#index.pairAt(place);
    const { crossings, beside } = this.#pairs;
    const [crosses, besides] = pair < 0 ? [0, 0] : [crossings[pair], beside[pair]];
    const meeting = { one: name(place.row), other: name(place.column), crossings: crosses, beside: besides };
    return meetingInWords(meeting, kind);
  }
}

/** Whether two places are of one pair, on either side of the diagonal. @param {Place} one @param {Place} other */
function isMirrored(one, other) {
  return one.row === other.column && one.column === other.row;
}
