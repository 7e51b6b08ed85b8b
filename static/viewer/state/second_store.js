import { partialAt, valueAt } from "./paths.js";
import { fromSecond, secondStatus } from "./second_status.js";
import { Look } from "./look.js";
import { StatusStore } from "./store.js";

/**
 * The page's one status, as a second mesh sees it: what is read is what it makes of it, what is written goes into the one
 * status.
 *
 *     const store = new SecondStore(first);
 *     store.know({ same: true, ... });
 *     store.set({ filters: { picking: isolate([3]) } });
 *
 * @extends {StatusStore<import("./status.js").Status>}
 */
export class SecondStore extends StatusStore {
  #first;
  #look;
  /** @type {import("./second_status.js").Second} */
  #known = { same: false, cells: 0, has: () => false, groups: () => false, frames: null, reach: null };

  /** @param {StatusStore} first */
  constructor(first) {
    super(first.defaults);
    this.#first = first;
    this.#look = new Look(first);
    this.#look.derive((status) => secondStatus(status, this.#known));
  }

  /** What is known of the second mesh, or has changed. @param {Partial<import("./second_status.js").Second>} known */
  know(known) {
    this.#known = { ...this.#known, ...known };
    this.#look.renew();
  }

  /** @override */
  get status() {
    return this.#look?.status ?? super.status; // the look is not there yet while this is made
  }

  /** @override @type {StatusStore["set"]} */
  set(partial, options) {
    return this.#first.set(fromSecond(partial, this.#known), options);
  }

  /** @override @type {StatusStore["setAt"]} */
  setAt(path, value, options) {
    return this.set(
      /** @type {import("./status.js").PartialStatus} */ (partialAt(this.status, path, value)),
      options,
    );
  }

  /** @override @type {StatusStore["valueAt"]} */
  valueAt(path) {
    return valueAt(this.status, path);
  }

  /** @override @type {StatusStore["on"]} */
  on(path, listener) {
    return this.#look.on(path, listener);
  }

  /** Follow the status no more. */
  stop() {
    this.#look.stop();
  }

  /** @override */
  seal() {
    this.#first.seal();
  }

  /** @override */
  undo() {
    return this.#first.undo();
  }

  /** @override */
  redo() {
    return this.#first.redo();
  }
}
