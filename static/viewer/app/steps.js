/**
 * Each mesh that is opened is a step of the browser's history: going back opens the one before, under the settings that it
 * had.
 *
 * @typedef {{ mesh: string | null, again: () => Promise<unknown>, status: import("../state/status.js").Status | null }} Step
 */
export class Steps {
  #app;
  /** @type {Step[]} */
  #steps = [];
  #at = -1;
  /** Whether a step is being gone back to, which is none of its own. */
  #going = false;

  /** What the address says of the mesh and of the one beside it. @type {{ mesh: string | null, beside: string | null }} */
  #named = { mesh: null, beside: null };

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
    this.#named = { ...this.#named, mesh };
    if (present !== mesh || !first) {
      address.search = this.#search();
      address.hash = "";
    }
    this.#steps.splice(++this.#at, Infinity, { mesh, again, status: null });
    const state = { step: this.#at };
    if (first) history.replaceState(state, "", address);
    else history.pushState(state, "", address);
  }

  /** A mesh was opened beside the first, or went. @param {string | null} mesh null for a file of this machine, or none */
  beside(mesh) {
    if (this.#named.beside === mesh) return;
    this.#named = { ...this.#named, beside: mesh };
    this.#rename();
  }

  /** Each of both meshes takes the place of the other. @param {() => Promise<unknown>} again opens the one that is the first now once more */
  swap(again) {
    const { mesh, beside } = this.#named;
    this.#named = { mesh: beside, beside: mesh };
    const step = this.#steps[this.#at];
    if (step) Object.assign(step, { mesh: beside, again });
    this.#rename();
  }

  #rename() {
    if (!this.#app.host.steps) return;
    const address = new URL(location.href);
    address.search = this.#search();
    history.replaceState(history.state, "", address);
  }

  /** The part of the address that names what is open. A comparison with a file of this machine can't be shared. */
  #search() {
    const { mesh, beside } = this.#named;
    const named = { mesh, with: mesh && beside };
    const parts = Object.entries(named).flatMap(([name, value]) =>
      value ? [`${name}=${value.includes(":") ? encodeURIComponent(value) : value}`] : [],
    );
    return parts.length ? `?${parts.join("&")}` : "";
  }

  /** @param {number} at */
  async #go(at) {
    const step = this.#steps[at];
    if (!step) return location.reload(); // of a page that was left meanwhile: its address says what it showed
    this.leave();
    this.#going = true;
    this.#at = at;
    this.#named = { ...this.#named, mesh: step.mesh };
    this.#rename(); // what stands beside it may be another than it was
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
