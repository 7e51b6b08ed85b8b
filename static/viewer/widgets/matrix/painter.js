import { componentsOf } from "../../colours/components.js";
import { raster } from "./raster.js";

/**
 * @typedef {import("./pair_index.js").PairIndex} PairIndex @typedef {import("./pair_index.js").Place} Place
 * @typedef {import("./window.js").Window} Window
 *
 * @typedef {object} Marks  what is drawn over the cells
 * @property {readonly number[]} things whose rows and columns are tinted
 * @property {readonly Place[]} outlined
 * @property {Place | null} cursor
 */

/** Tokens of what a pixel shows, by the numbers of `raster.js`: nothing lets through what lies below. */
const TOKENS = [null, "--hairline", "--crossing", "--beside", "--crossing-beside"];

/** How much paper lies over what is not in a row or column of a marked thing. */
const VEIL = 0.5;

/** The rows and columns of marked things are no narrower, in pixels of the page. */
const NARROWEST_BAND = 2;

/** Rings are no smaller, in pixels of the page, so that they are seen around a cell of a pixel. */
const SMALLEST_RING = 8;

/** Draws the matrix on a canvas: the cells once for each window, the marks over them as often as is asked. */
export class Painter {
  #canvas;
  #cells = document.createElement("canvas");

  /** The cells' pixels, as numbers and as colours: kept, since a hand asks for many pictures of one size. */
  #codes = new Uint8Array(0);
  /** @type {ImageData | null} */
  #image = null;

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#canvas = canvas;
  }

  /** Pixels along a side, and how many of them make one of the page's. */
  get #pixels() {
    return this.#canvas.width;
  }

  get #ratio() {
    return this.#pixels / this.#canvas.clientWidth;
  }

  /** Follow the size that the canvas has in the page. @returns {boolean} whether it is another now */
  fit() {
    const pixels = Math.round(this.#canvas.clientWidth * devicePixelRatio);
    if (pixels === this.#pixels) return false;
    for (const canvas of [this.#canvas, this.#cells]) canvas.width = canvas.height = pixels;
    return true;
  }

  /** Draw the cells anew. @param {PairIndex} index @param {Window} window */
  drawCells(index, window) {
    const pixels = this.#pixels;
    if (!pixels) return;
    const context = contextOf(this.#cells);
    if (this.#image?.width !== pixels) {
      this.#image = context.createImageData(pixels, pixels);
      this.#codes = new Uint8Array(pixels * pixels);
    }
    const words = new Uint32Array(this.#image.data.buffer);
    const inks = Uint32Array.from(TOKENS, (name) => (name ? wordOf(this.#token(name), context) : 0));
    raster(index, window, pixels, this.#codes);
    for (let at = 0; at < words.length; at++) words[at] = inks[this.#codes[at]];
    context.putImageData(this.#image, 0, 0);
  }

  /** Put the cells on the screen, and the marks over them. @param {Window} window @param {Marks} marks */
  draw(window, { things, outlined, cursor }) {
    const pixels = this.#pixels;
    if (!pixels) return;
    const context = contextOf(this.#canvas);
    context.fillStyle = this.#token("--surface");
    context.fillRect(0, 0, pixels, pixels);
    context.drawImage(this.#cells, 0, 0);
    if (things.length) this.#bands(context, window, things);
    for (const place of outlined) this.#ring(context, window, place, "--accent");
    if (cursor) this.#ring(context, window, cursor, "--ink");
  }

  /** Rows and columns of things as they are, on a tinted ground, and all else paler. @param {CanvasRenderingContext2D} context @param {Window} window @param {readonly number[]} things */
  #bands(context, { x, y, size }, things) {
    const pixels = this.#pixels;
    const scale = pixels / size;
    const narrowest = Math.round(NARROWEST_BAND * this.#ratio);
    const edge = (/** @type {number} */ thing) => Math.floor(thing * scale);
    const along = (/** @type {number} */ from) =>
      things
        .map((thing) => [edge(thing - from), edge(thing + 1 - from)])
        .map(([start, end]) => ({ start, width: Math.max(narrowest, end - start) }))
        .filter(({ start, width }) => start > -width && start < pixels);
    context.globalAlpha = VEIL;
    context.fillRect(0, 0, pixels, pixels);
    context.globalAlpha = 1;
    context.fillStyle = this.#token("--accent-soft");
    const bands = [
      ...along(y).map(({ start, width }) => [0, start, pixels, width]),
      ...along(x).map(({ start, width }) => [start, 0, width, pixels]),
    ];
    for (const [left, top, w, h] of bands) context.fillRect(left, top, w, h);
    context.beginPath();
    for (const [left, top, w, h] of bands) context.rect(left, top, w, h);
    context.save();
    context.clip();
    context.drawImage(this.#cells, 0, 0);
    context.restore();
  }

  /** A ring around a cell, with a rim that parts it from whatever lies there. @param {CanvasRenderingContext2D} context @param {Window} window @param {Place} place @param {string} token */
  #ring(context, { x, y, size }, { row, column }, token) {
    const scale = this.#pixels / size;
    const side = Math.max(scale, SMALLEST_RING * this.#ratio);
    const corner = (/** @type {number} */ start) => (start + 0.5) * scale - side / 2;
    for (const [ink, width] of /** @type {const} */ ([
      ["--surface", 4],
      [token, 2],
    ])) {
      // prettier-ignore
      context.strokeStyle = this.#token(ink);
      context.lineWidth = width * this.#ratio;
      context.strokeRect(corner(column - x), corner(row - y), side, side);
    }
  }

  /** @param {string} name */
  #token(name) {
    return getComputedStyle(this.#canvas).getPropertyValue(name).trim();
  }
}

/** @param {HTMLCanvasElement} canvas */
function contextOf(canvas) {
  return /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));
}

/** A colour as the four bytes of a pixel have it. @param {string} colour however it is written @param {CanvasRenderingContext2D} context */
function wordOf(colour, context) {
  context.fillStyle = colour;
  const [r, g, b] = componentsOf(String(context.fillStyle)).map((part) => Math.round(255 * part));
  return new Uint32Array(Uint8Array.of(r, g, b, 255).buffer)[0];
}
