import { mapColours } from "../colours/palettes.js";
import { toCsv } from "../charts/export.js";
import { withSecond } from "../charts/second.js";
import { textOf } from "../figure/compose.js";
import { keysOf } from "../figure/keys.js";
import { printed } from "../figure/histogram.js";
import { rasterised } from "../figure/raster.js";
import { quantityOf } from "../state/quantity.js";
import { plainUnitOf, titled } from "../state/units.js";
import { safeStem } from "../files/names.js";
import { writeStatus } from "../files/png_text.js";
import { statusToHash } from "../state/link.js";

/** @typedef {import("../widgets/bind.js").ChartFormat} ChartFormat */

/** Hand a file to the user. @param {Blob} blob @param {string} name */
export function saveFile(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** Worst cells that are listed in a file, and rows that are written at a time. */
const LISTED = 1000;
const ROWS = 65_536;

/** @param {readonly string[]} lines */
const csvOf = (lines) => new Blob([lines.join("\r\n"), "\r\n"], { type: "text/csv" });

/** @param {string} text */
const quoted = (text) => (/[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

/** @param {string} id */
const safe = (id) => id.replace(/[^\w-]+/g, "-");

/** As numpy and most programs read it. @param {number} value */
const written = (value) =>
  Number.isFinite(value) ? String(value) : Number.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf";

/** Points to an inch. */
const POINTS = 72;

/** Pixels of a picture's side. */
export const LARGEST_SIDE = 8192;

/** @param {{ width?: number, height?: number }} options @throws {Error} a side that no picture can have */
function checkSize(options) {
  for (const side of /** @type {const} */ (["width", "height"])) {
    const value = options[side];
    if (value === undefined) continue;
    if (!Number.isInteger(value) || value < 1 || value > LARGEST_SIDE)
      throw new Error(
        `found ${value} as the picture's ${side}, expected a whole number from 1 to ${LARGEST_SIDE}`,
      );
  }
}

/** Whose histogram it is, and whose is over it. @param {{ beside: object | null }} data @param {import("../state/facts.js").Facts} facts */
function namesIn({ beside }, facts) {
  const name = facts.get("summary")?.name ?? "";
  return beside ? `${name}; line: ${facts.get("second")?.get("summary")?.name ?? ""}` : name;
}

/** What leaves the page: pictures, histograms, settings, links. */
export class Saving {
  #app;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /** The mesh's name without its ending, for file names. */
  get stem() {
    return safeStem(this.#app.facts.get("summary")?.name ?? "");
  }

  /** The picture with the status in it. @param {{ width?: number, height?: number, transparent?: boolean }} [options] @returns {Promise<Blob>} */
  async picture(options = {}) {
    const { scene, store } = this.#app;
    checkSize(options);
    return writeStatus(await scene.screenshot(options), JSON.stringify(store.status));
  }

  saveStatus() {
    saveFile(
      new Blob([this.#app.documents.text()], { type: "application/json" }),
      `${this.stem}.hexalab.json`,
    );
  }

  /** The head of a column of values: the metric's id, and its unit where that is named. */
  get #column() {
    const { id, lengthPower } = quantityOf(this.#app);
    return quoted(titled(id, plainUnitOf(this.#app.store.status, lengthPower)));
  }

  /** The list of worst cells as CSV, the metric named in its head. */
  async saveWorst() {
    await this.#tried(async () => {
      const { id } = quantityOf(this.#app);
      const length = plainUnitOf(this.#app.store.status, 1);
      const head = ["cell", this.#column, ...["x", "y", "z"].map((axis) => titled(axis, length))];
      const numbering = this.#app.facts.get("numbering");
      const { cells, values, places } = await this.#app.client.call("worst", [id, LISTED]);
      const rows = cells.map((cell, row) => [numbering.of(cell), values[row], ...places[row]].join(","));
      saveFile(csvOf([head.join(","), ...rows]), `${this.stem}-worst-${safe(id)}.csv`);
    });
  }

  /** The value of every cell as CSV, the metric named in its head. */
  async saveValues() {
    await this.#tried(async () => {
      const { id } = quantityOf(this.#app);
      const values = await this.#app.client.call("values", [id]);
      const numbering = this.#app.facts.get("numbering");
      /** @type {string[]} */
      const parts = [];
      for (let first = 0; first < values.length; first += ROWS)
        parts.push(
          Array.from(
            values.subarray(first, first + ROWS),
            (value, row) => `${numbering.of(first + row)},${written(value)}`,
          ).join("\r\n"),
        );
      saveFile(csvOf([`cell,${this.#column}`, ...parts]), `${this.stem}-${safe(id)}.csv`);
    });
  }

  /** The figure that the status asks for, as a PNG. @param {{ width?: number, height?: number } | null} size pixels, instead of what the status asks for */
  figure(size) {
    return this.#app.figures.file("png", size);
  }

  /** @param {ChartFormat} format */
  async saveHistogram(format) {
    await this.#tried(async () => {
      const blob = await this.histogram(format);
      const quantity = this.#app.facts.get("histogram")?.quantity ?? "";
      if (blob) saveFile(blob, `${this.stem}-${safe(quantity)}.${format}`);
    });
  }

  /** The histogram as a file; a PNG carries the status. @param {ChartFormat} format @returns {Promise<Blob | null>} */
  async histogram(format) {
    const { store, facts } = this.#app;
    const own = facts.get("histogram");
    if (!own) return null;
    const data = withSecond(own, facts);
    const quantity = quantityOf(this.#app);
    if (format === "csv") {
      const unit = plainUnitOf(store.status, quantity.lengthPower);
      const second = data.beside && (facts.get("second")?.get("histogram") ?? null);
      return new Blob([toCsv(data, data.quantity, unit, second)], { type: "text/csv" });
    }
    const { histogram, colour, figure } = store.status;
    const highFirst = facts.get("colour")?.high_first ?? false;
    const scale = {
      data,
      colour: mapColours(colour, highFirst),
      keys: keysOf(data, colour, highFirst),
      acceptable: quantity.acceptable,
      title: histogram.title || `${titled(quantity.name, quantity.unit)}, ${namesIn(data, facts)}`,
    };
    const { svg, width, height } = printed(scale, histogram);
    if (format === "svg") return new Blob([textOf(svg)], { type: "image/svg+xml" });
    if (format === "pdf") return (await import("../figure/pdf.js")).toPdf(svg, width, height);
    const [wide, high] = [width, height].map((side) => Math.round((side * figure.resolution) / POINTS));
    for (const [name, side] of /** @type {const} */ ([
      ["width", wide],
      ["height", high],
    ]))
      svg.setAttribute(name, String(side));
    const png = await rasterised({ width: wide, height: high, background: "#ffffff" }, [], textOf(svg));
    return writeStatus(png, JSON.stringify(store.status));
  }

  /** The address of this page with mesh and view. */
  async link() {
    const { store } = this.#app;
    const address = new URL(location.href);
    for (const own of ["embed", "origin"]) address.searchParams.delete(own); // of a frame
    address.hash = await statusToHash(store.status, store.defaults);
    return address.href;
  }

  /** @param {() => Promise<void>} save */
  async #tried(save) {
    try {
      await save();
      this.#app.messages.settle("save");
    } catch (error) {
      this.#app.messages.error(error, { topic: "save" });
    }
  }
}
