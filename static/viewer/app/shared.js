import { Superseded } from "../core/client.js";

/**
 * What a notebook's page and its kernel share: all settings, the cell in the inspector, and pictures.
 *
 * @typedef {import("../core/kernel_transport.js").Port} Port
 */

/** Milliseconds after a change until the kernel is told. */
const REST = 250;

/** Milliseconds of rest until the picture that stays in the notebook is taken. */
const STILL = 1500;

export class Shared {
  #app;
  #port;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #telling;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #taking;
  /** Whether it was looked what is picked. */
  #picked = false;
  /** What both know, as text. */
  #known = "";

  /** @param {import("./app.js").App} app @param {Port} port */
  constructor(app, port) {
    this.#app = app;
    this.#port = port;
  }

  start() {
    const { store, facts } = this.#app;
    store.on("*", () => this.#changed());
    facts.on("shown", () => {
      this.#pickFirst();
      this.#changed();
    });
    facts.on("cell", (cell) => this.#port.set("picked", cell ? [cell.cell] : []));
    this.#port.follow("status", (status) => void this.#apply(status));
    this.#port.follow("picked", (picked) => this.#pick(picked));
    this.#port.on("screenshot", (question) => void this.#give(question));
  }

  /** What was picked before the mesh was there. */
  #pickFirst() {
    if (this.#picked || !this.#app.facts.get("shown")) return;
    this.#picked = true;
    this.#pick(this.#port.get("picked"));
  }

  #changed() {
    if (!this.#app.facts.get("summary")) return;
    clearTimeout(this.#telling);
    clearTimeout(this.#taking);
    this.#telling = setTimeout(() => this.#tell(), REST);
    this.#taking = setTimeout(() => void this.#still(), STILL);
  }

  #tell() {
    const { status } = this.#app.store;
    const text = JSON.stringify(status);
    if (text === this.#known) return;
    this.#known = text;
    this.#port.set("status", status);
  }

  /** The kernel has set the settings, whole or in part. @param {object} status */
  async #apply(status) {
    if (JSON.stringify(status) === this.#known || !this.#app.facts.get("summary")) return;
    try {
      await this.#app.documents.apply(status);
    } catch (error) {
      if (!(error instanceof Superseded)) this.#app.messages.error(error, { topic: "status" });
    }
    this.#known = "";
    this.#changed(); // the kernel hears the whole
  }

  /** @param {readonly number[]} picked */
  #pick(picked) {
    const cell = picked.length ? picked[0] : null;
    if ((this.#app.facts.get("cell")?.cell ?? null) !== cell) void this.#app.inspect(cell);
  }

  /** @param {{ number: number, options: { width?: number, height?: number, transparent?: boolean } }} question */
  async #give({ number, options }) {
    try {
      await this.#app.drawing.drawn();
      await this.#app.scene.settled();
      const picture = await this.#app.saving.picture(options);
      this.#port.send({ kind: "picture", of: number }, await picture.arrayBuffer());
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      this.#port.send({ kind: "picture", of: number, error: reason });
    }
  }

  /** The picture that stays: as the view is now. */
  async #still() {
    const { scene, saving, drawing } = this.#app;
    try {
      await drawing.drawn();
      await scene.settled();
      const picture = await saving.picture();
      this.#port.send({ kind: "still" }, await picture.arrayBuffer());
    } catch {
      return; // a view that is hidden has no picture
    }
  }
}
