import { Superseded } from "../core/client.js";
import { saveFile } from "./saving.js";

/**
 * How far two surfaces are apart, both ways: the page's mesh and what it is compared with. Measured in shares, so that a slice
 * can come between; two meshes by both cores at once.
 *
 * @typedef {import("../state/facts.js").Apart} Apart
 */
export class Distances {
  #app;
  #comparing;
  /** @type {Promise<Apart | null> | null} */
  #measured = null;
  #turn = 0;

  /** @param {import("./app.js").App} app @param {import("./comparing.js").Comparing} comparing */
  constructor(app, comparing) {
    this.#app = app;
    this.#comparing = comparing;
  }

  /** What was measured is of other surfaces. */
  forget() {
    this.#turn++;
    this.#measured = null;
    this.#app.facts.set({ apart: null, measuring: null });
  }

  /** @returns {Promise<Apart | null>} null if it failed, which was said, or the surfaces went */
  measure() {
    return (this.#measured ??= this.#measure(this.#turn));
  }

  /** @param {number} turn */
  async #measure(turn) {
    const { facts, messages } = this.#app;
    const here = () => turn === this.#turn;
    await this.#comparing.matched;
    if (!facts.get("comparison")) return null;
    const { second } = this.#comparing;
    const back = second === null;
    const sides = second ? [this.#app, second] : [this.#app];
    /** @type {import("../state/answers.js").Measured[]} */
    const shares = sides.map(() => ({ done: 0, of: 0 }));
    const sum = (/** @type {"done" | "of"} */ part) => shares.reduce((all, one) => all + one[part], 0);
    try {
      await Promise.all(
        sides.map(async ({ client }, k) => {
          do {
            shares[k] = await client.call("measure_distance", [back]);
            if (here()) facts.set({ measuring: { done: sum("done"), of: sum("of") } });
          } while (here() && shares[k].done < shares[k].of);
        }),
      );
      if (!here()) return null;
      const diagonal = facts.get("comparison")?.diagonal ?? null;
      const [ours, theirs] = await Promise.all(
        sides.map(({ client }) => client.call("distance_facts", [back, diagonal])),
      );
      const to = ours.there;
      const from = theirs ? theirs.there : ours.back;
      if (!here() || !from) return null;
      const apart = {
        a_to_b: to,
        b_to_a: from,
        hausdorff: Math.max(to.max, from.max),
        hausdorff_percent: Math.max(to.max_percent, from.max_percent),
      };
      facts.set({ apart, measuring: null });
      return apart;
    } catch (error) {
      if (!here()) return null;
      this.forget();
      if (!(error instanceof Superseded)) messages.error(error, { topic: "compare" });
      return null;
    }
  }

  /** The distance of every vertex of the first mesh's boundary, as CSV. */
  async save() {
    const { client, messages, saving } = this.#app;
    try {
      const text = await client.call("distance_csv");
      saveFile(new Blob([text], { type: "text/csv" }), `${saving.stem}-distance.csv`);
    } catch (error) {
      messages.error(error, { topic: "save" });
    }
  }
}
