/**
 * Each mesh that is opened is a step of the browser's history: going back opens the one before, under the settings that it
 * had.
 *
 * @typedef {{ again: () => Promise<unknown>, status: import("../state/status.js").Status | null }} Step
 */
export class Steps {
  #app;
  /** @type {Step[]} */
  #steps = [];
  #at = -1;
  /** Whether a step is being gone back to, which is none of its own. */
  #going = false;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /** Begin to listen to the browser's buttons. */
  start() {
    if (!this.#app.host.steps) return;
    window.addEventListener("popstate", ({ state }) => {
      if (typeof state?.step === "number") void this.#go(state.step);
    });
  }

  /** Another mesh is asked for: what is set is kept for whoever comes back. */
  leave() {
    const step = this.#steps[this.#at];
    if (step && !this.#going) step.status = this.#app.store.status;
  }

  /**
   * A mesh was opened: the page's address names it, so that a link to it is right.
   *
   * @param {string | null} mesh null for a file of this machine
   * @param {() => Promise<unknown>} again opens it once more
   */
  add(mesh, again) {
    if (this.#going || !this.#app.host.steps) return;
    const address = new URL(location.href);
    const present = new URLSearchParams(address.search).get("mesh");
    const first = this.#at < 0;
    if (present !== mesh || !first) {
      address.search = mesh === null ? "" : `?mesh=${mesh.includes(":") ? encodeURIComponent(mesh) : mesh}`;
      address.hash = "";
    }
    this.#steps.splice(++this.#at, Infinity, { again, status: null });
    const state = { step: this.#at };
    if (first) history.replaceState(state, "", address);
    else history.pushState(state, "", address);
  }

  /** @param {number} at */
  async #go(at) {
    const step = this.#steps[at];
    if (!step) return location.reload(); // of a page that was left meanwhile: its address says what it showed
    this.leave();
    this.#going = true;
    this.#at = at;
    const { documents, drawing } = this.#app;
    try {
      await step.again();
      if (step.status) await documents.replaceBy([step.status]);
      await drawing.update();
    } catch {
      // said in a message by whoever failed
    } finally {
      this.#going = false;
    }
  }
}
