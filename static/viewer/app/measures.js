import { Superseded } from "../core/client.js";
import { Numbering } from "../state/numbering.js";
import { quantityOf } from "../state/quantity.js";

/** @typedef {import("../core/types.js").Methods} Methods */

/**
 * Keeps statistics, histogram and the mesh's description up to date: each is asked for after the picture stands, and
 * again when what it is about changes.
 */
export class Measures {
  #app;

  /** @param {import("./side.js").Side} app */
  constructor(app) {
    this.#app = app;
    app.look.on("colour", () => this.#measure());
    app.look.on("histogram.bins", () => this.#measure());
  }

  /** Resolves when everything about the mesh that was opened last is known. @type {Promise<void>} */
  filled = Promise.resolve();

  /** Everything about a mesh that was just opened, part by part, so that a slice need not wait for the whole. */
  fill() {
    this.filled = this.#fill();
    return this.filled;
  }

  async #fill() {
    const { facts, drawing, client, tables } = this.#app;
    const numbers = await this.#ask("numbers", []);
    if (numbers) facts.set({ numbering: new Numbering(numbers) });
    await this.#measure();
    const summary = facts.get("summary");
    let describe = 0;
    for (const part of tables.described) {
      const found = await this.#ask("describe", [part]);
      if (!found || facts.get("summary") !== summary) return;
      describe += client.milliseconds.describe ?? 0;
      facts.set({ description: { ...facts.get("description"), ...found } });
      if (found.cells_per_depth) facts.set({ layers: found.cells_per_depth.length });
      if (part === "edges") await drawing.update();
    }
    this.#app.note({ describe });
  }

  /** Resolves when statistics and histogram are those of the open mesh. */
  measured() {
    return this.#measure();
  }

  /** The quantity that the mesh is drawn by, as far as it has it. */
  #looked() {
    const { look, facts, tables } = this.#app;
    return quantityOf({ store: look, facts, tables });
  }

  /** Statistics of a metric or an attribute, asked for where they are not known yet. @param {string} id */
  async know(id) {
    const { facts } = this.#app;
    const summary = facts.get("summary");
    const known = facts.get("statistics")[id];
    if (known || !summary || facts.get("core") !== "ready") return known ?? null;
    const found = await this.#app.client.call("quality", [id]).catch(() => null); // the mesh went, or has no such attribute
    if (found && facts.get("summary") === summary)
      facts.set({ statistics: { ...facts.get("statistics"), [id]: found } });
    return found;
  }

  /** Statistics and histogram of the metric or attribute that is looked at. */
  async #measure() {
    const { facts, look, client } = this.#app;
    const summary = facts.get("summary");
    if (!summary || facts.get("core") !== "ready") return;
    const { id } = this.#looked();
    const { histogram: { bins }, colour } = look.status; // prettier-ignore
    const asked = JSON.stringify([bins, colour.range, colour.reach]);
    const known = facts.get("histogram");
    if (known?.quantity === id && known.asked === asked) return;
    const statistics = facts.get("statistics")[id] ?? (await this.#ask("quality", [id]));
    const histogram = await this.#ask("histogram", [id, bins]);
    if (!histogram || facts.get("summary") !== summary || this.#looked().id !== id) return;
    facts.set({
      statistics: { ...facts.get("statistics"), ...(statistics ? { [id]: statistics } : {}) },
      histogram: { ...histogram, asked },
    });
    this.#app.note({ quality: client.milliseconds.quality });
    await this.#findWorst(id);
  }

  /** The worst cells by the metric or attribute that is looked at. @param {string} id */
  async #findWorst(id) {
    const { facts } = this.#app;
    const summary = facts.get("summary");
    if (facts.get("worst")?.quantity === id) return;
    const worst = await this.#ask("worst", [id]);
    if (worst && facts.get("summary") === summary && this.#looked().id === id)
      facts.set({ worst: { ...worst, quantity: id } });
  }

  /**
   * @template {keyof Methods} Method
   * @param {Method} method @param {Methods[Method]["args"]} args
   * @returns {Promise<Methods[Method]["answer"] | null>} null if it was superseded or failed
   */
  async #ask(method, args) {
    try {
      return await this.#app.client.call(method, args, { replace: method });
    } catch (error) {
      if (!(error instanceof Superseded)) this.#app.messages.error(error, { topic: method });
      return null;
    }
  }
}
