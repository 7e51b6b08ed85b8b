import { Superseded } from "../core/client.js";

/** What of groups is measured when it is asked for. */
export class Grouped {
  #app;
  /** What is under way, by method and arguments, and the mesh that it is of. @type {Map<string, object | null>} */
  #asked = new Map();

  /** @param {import("./side.js").Side} app */
  constructor(app) {
    this.#app = app;
  }

  /** Size and quality of every group of cells. */
  async measure() {
    const rows = await this.#ask("group_table", []);
    if (rows) this.#app.facts.set({ groupMeasures: Object.fromEntries(rows.map((row) => [row.id, row])) });
  }

  /** Where the groups of an origin meet. @param {string} origin */
  async meet(origin) {
    const rows = await this.#ask("interfaces", [origin]);
    if (rows) this.#app.facts.set({ interfaces: { origin, rows } });
  }

  /**
   * @template {"group_table" | "interfaces"} Method
   * @param {Method} method @param {import("../core/types.js").Methods[Method]["args"]} args
   * @returns {Promise<import("../core/types.js").Methods[Method]["answer"] | null>} null if it failed, is under way already, or the mesh went
   */
  async #ask(method, args) {
    const { facts, client, messages } = this.#app;
    const summary = facts.get("summary");
    const key = JSON.stringify([method, args]);
    if (facts.get("core") !== "ready" || this.#asked.get(key) === summary) return null;
    this.#asked.set(key, summary);
    try {
      const found = await client.call(method, args, { replace: method });
      return facts.get("summary") === summary ? found : null;
    } catch (error) {
      if (!(error instanceof Superseded)) messages.error(error, { topic: method });
      return null;
    } finally {
      if (this.#asked.get(key) === summary) this.#asked.delete(key);
    }
  }
}
