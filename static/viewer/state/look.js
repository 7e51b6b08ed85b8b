import { changedPaths, deepFreeze, touches } from "./paths.js";

/** @typedef {import("./status.js").Status} Status */

/**
 * The settings as one mesh is drawn under them: those of the status, but for what follows from more than the status, as
 * of a second mesh from the first.
 *
 *     const look = new Look(store);
 *     look.on("*", (status) => scene.setStatus(status));
 *     look.derive((status) => ({ ...status, mesh: other }));
 */
export class Look {
  #store;
  #stop;
  /** @type {(status: Status) => Status} */
  #made = (status) => status;
  /** @type {Status} */
  #status;
  /** @type {{ path: string, listener: (status: Status, changed: readonly string[]) => void }[]} */
  #listeners = [];

  /** @param {import("./store.js").StatusStore} store */
  constructor(store) {
    this.#store = store;
    this.#status = store.status;
    this.#stop = store.on("*", () => this.renew());
  }

  get status() {
    return this.#status;
  }

  /** How it is made of the status from now on. @param {(status: Status) => Status} make */
  derive(make) {
    this.#made = make;
    this.renew();
  }

  /** What it is made of may have changed. */
  renew() {
    const next = deepFreeze(this.#made(this.#store.status));
    const changed = changedPaths(this.#status, next);
    this.#status = next;
    if (!changed.length) return;
    for (const { path, listener } of [...this.#listeners])
      if (path === "*" || changed.some((one) => touches(path, one))) listener(next, changed);
  }

  /** Follow the status no more. */
  stop() {
    this.#stop();
    this.#listeners = [];
  }

  /**
   * @param {string} path or "*" for every change @param {(status: Status, changed: readonly string[]) => void} listener
   * @returns {() => void} stops listening
   */
  on(path, listener) {
    const entry = { path, listener };
    this.#listeners.push(entry);
    return () => void (this.#listeners = this.#listeners.filter((one) => one !== entry));
  }
}
