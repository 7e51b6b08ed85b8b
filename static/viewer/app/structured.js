import { Superseded } from "../core/client.js";
import { cameraOnCell } from "../state/camera.js";
import { variantOf } from "../state/structure.js";
import { FLIGHT } from "./views.js";

/**
 * @typedef {import("../core/types.js").Methods} Methods
 * @typedef {import("../state/structure.js").Kind} Kind
 */

/** The structure of the open mesh: traced part by part, told as tables, gone to. */
export class Structured {
  #app;
  /** @type {{ summary: object | null, done: Promise<boolean> } | null} */
  #tracing = null;
  /** Tables by name and variant, of the open mesh. @type {Map<string, import("../state/answers.js").StructureTable>} */
  #tables = new Map();
  /** @type {object | null} */
  #of = null;

  /** @param {import("./side.js").Side} app */
  constructor(app) {
    this.#app = app;
  }

  /** Trace it, part by part, so that a slice can come between. @returns {Promise<boolean>} whether the open mesh is traced */
  trace() {
    const { facts } = this.#app;
    const summary = facts.get("summary");
    if (!summary || facts.get("core") !== "ready") return Promise.resolve(false);
    if (this.#tracing?.summary !== summary) this.#tracing = { summary, done: this.#trace(summary) };
    return this.#tracing.done;
  }

  /** @param {object} summary of the mesh that it is begun for */
  async #trace(summary) {
    const { client, facts, measures } = this.#app;
    await measures.filled;
    const here = () => facts.get("summary") === summary;
    for (let next = /** @type {string | null} */ (""); next !== null && here(); ) {
      const traced = await this.#ask("trace", []);
      if (!traced || !here()) break;
      next = traced.next;
      facts.set({ tracing: traced });
    }
    const structure = here() ? await this.#ask("structure_facts", []) : null;
    if (!structure || !here()) {
      this.#tracing = null;
      return false;
    }
    facts.set({ structure, tracing: null });
    this.#app.note({ trace: client.milliseconds.trace });
    const cell = facts.get("cell");
    if (cell) void this.#app.inspect(cell.cell);
    return true;
  }

  /** A table of things of a kind, as the status has them; null if it failed or the mesh went. @param {Kind | "nodes"} kind */
  async table(kind) {
    const variant = variantOf(this.#app.store.status.structure, kind);
    const summary = this.#app.facts.get("summary");
    if (this.#of !== summary) {
      this.#tables.clear();
      this.#of = summary;
    }
    const key = `${kind} ${variant}`;
    const known = this.#tables.get(key);
    if (known) return known;
    const found = await this.#ask("structure_table", [kind, variant]);
    if (!found || this.#app.facts.get("summary") !== summary) return null;
    this.#tables.set(key, found);
    return found;
  }

  /** The same as CSV. @param {Kind} kind */
  csv(kind) {
    return this.#ask("structure_csv", [kind, variantOf(this.#app.store.status.structure, kind)]);
  }

  /** All facts, with the hashes of the labels. */
  facts() {
    return this.#ask("structure_facts", [true]);
  }

  /** Which sheets meet. */
  pairs() {
    return this.#ask("sheet_pairs", []);
  }

  /** Go to some things. @param {Kind} kind @param {readonly number[]} numbers */
  async flyTo(kind, numbers) {
    const { store } = this.#app;
    const around = await this.#ask("structure_box", [kind, numbers, variantOf(store.status.structure, kind)]);
    if (!around) return;
    const size = Math.max(around.size / 4, 1e-4);
    store.set({ camera: cameraOnCell(store.status.camera, { ...around, size }) }, { undo: "fly" });
  }

  /** Show nothing else than some things, or nothing of them. @param {Kind} kind @param {readonly number[]} numbers @param {"inside" | "outside"} keep */
  filter(kind, numbers, keep) {
    const { store, views } = this.#app;
    const none = { blocks: [], sheets: [], chords: [] };
    const { complex } = store.status.structure;
    store.seal();
    store.set(
      { filters: { structure: { enabled: true, keep, complex, ...none, [kind]: [...numbers] } } },
      { undo: FLIGHT },
    );
    if (keep === "inside") void views.flyToShown();
  }

  /**
   * @template {"trace" | "structure_facts" | "structure_table" | "structure_csv" | "sheet_pairs" | "structure_box"} Method
   * @param {Method} method @param {Methods[Method]["args"]} args
   * @returns {Promise<Methods[Method]["answer"] | null>} null if it failed
   */
  async #ask(method, args) {
    try {
      return await this.#app.client.call(method, args);
    } catch (error) {
      if (!(error instanceof Superseded)) this.#app.messages.error(error, { topic: "structure" });
      return null;
    }
  }
}
