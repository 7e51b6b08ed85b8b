import { mapColours } from "../colours/palettes.js";
import { toCsv, toPng, toSvg } from "../charts/export.js";
import { quantityOf } from "../state/quantity.js";
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

/** What leaves the page: pictures, histograms, settings, links. */
export class Saving {
  #app;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /** The mesh's name without its extensions, for file names. */
  get stem() {
    const name = this.#app.facts.get("summary")?.name ?? "hexalab";
    return name.replace(/(\.[a-z0-9]{1,5}){1,2}$/i, "") || "hexalab";
  }

  /** The picture with the status in it. @param {{ width?: number, height?: number, transparent?: boolean }} [options] @returns {Promise<Blob>} */
  async picture(options = {}) {
    const { scene, store } = this.#app;
    return writeStatus(await scene.screenshot(options), JSON.stringify(store.status));
  }

  /** @param {{ width?: number, height?: number, transparent?: boolean }} options */
  async savePicture(options) {
    await this.#tried(async () => saveFile(await this.picture(options), `${this.stem}.png`));
  }

  saveStatus() {
    saveFile(
      new Blob([this.#app.documents.text()], { type: "application/json" }),
      `${this.stem}.hexalab.json`,
    );
  }

  /** @param {ChartFormat} format */
  async saveHistogram(format) {
    await this.#tried(async () => {
      const blob = await this.histogram(format);
      const quantity = this.#app.facts.get("histogram")?.quantity ?? "";
      if (blob) saveFile(blob, `${this.stem}-${quantity.replace(/[^\w-]+/g, "-")}.${format}`);
    });
  }

  /** The histogram as a file; a PNG carries the status. @param {ChartFormat} format @returns {Promise<Blob | null>} */
  async histogram(format) {
    const { store, facts } = this.#app;
    const data = facts.get("histogram");
    if (!data) return null;
    if (format === "csv") return new Blob([toCsv(data)], { type: "text/csv" });
    const quantity = quantityOf(this.#app);
    const { orientation, scale } = store.status.histogram;
    const title = `${quantity.name}, ${facts.get("summary")?.name ?? ""}`;
    const svg = toSvg(data, {
      orientation,
      scale,
      title,
      colour: mapColours(store.status.colour.map),
      acceptable: quantity.acceptable,
    });
    if (format === "svg") return new Blob([svg], { type: "image/svg+xml" });
    return writeStatus(await toPng(svg), JSON.stringify(store.status));
  }

  /** The address of this page with mesh and view. */
  async link() {
    const { store } = this.#app;
    const address = new URL(location.href);
    address.hash = await statusToHash(store.status, store.defaults);
    return address.href;
  }

  /** @param {() => Promise<void>} save */
  async #tried(save) {
    try {
      await save();
    } catch (error) {
      this.#app.messages.error(error, { topic: "save" });
    }
  }
}
