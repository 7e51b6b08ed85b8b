import { changedPaths, deepFreeze, merge, partialAt, touches, valueAt } from "./paths.js";

/**
 * @typedef {import("./status.js").Status} Status
 * @typedef {{ undo?: string | false }} SetOptions  `undo`: a key under which changes in a row are one step; false: not a step
 */

/**
 * @template T
 * @typedef {import("./status.js").Part<T>} Part
 */

const HISTORY_LIMIT = 200;

/**
 * The status document of the page: the one place where settings live. Panels, keys, files and links write it;
 * the scene and the core read it. Documents are frozen; a change makes a new one that shares what stayed.
 *
 *     const store = new StatusStore(defaults);
 *     store.on("filters.peel", (status) => draw(status.filters.peel.depth));
 *     store.set({ filters: { peel: { depth: 2 } } });
 *     store.undo();
 *
 * @template {object} [Whole=Status]
 */
export class StatusStore {
  /** @type {Whole} */ #defaults;
  /** @type {Whole} */ #status;
  /** @type {Set<{ path: string, listener: (status: Whole, changed: readonly string[]) => void }>} */
  #listeners = new Set();
  /** @type {Whole[]} */ #past = [];
  /** @type {Whole[]} */ #future = [];
  /** @type {string | null} */ #openKey = null;
  /** @type {Set<string>} */ #touched = new Set();

  /** @param {Whole} defaults */
  constructor(defaults) {
    this.#defaults = deepFreeze(structuredClone(defaults));
    this.#status = this.#defaults;
  }

  get status() {
    return this.#status;
  }

  get defaults() {
    return this.#defaults;
  }

  /** Sections that were changed by steps since the program began, or since `untouch`. @returns {ReadonlySet<string>} */
  get touched() {
    return this.#touched;
  }

  /** These sections were changed by hand. @param {Iterable<string>} sections */
  touch(sections) {
    for (const section of sections) this.#touched.add(section);
  }

  /** Nothing was changed by hand so far. */
  untouch() {
    this.#touched.clear();
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /**
   * Merge a partial document into the status and tell the listeners.
   *
   * @param {Part<Whole>} partial @param {SetOptions} [options]
   * @returns {readonly string[]} paths that changed
   */
  set(partial, { undo } = {}) {
    const next = merge(this.#status, structuredClone(partial));
    if (next === this.#status) return [];
    if (undo !== false) {
      const continues = undo !== undefined && undo === this.#openKey;
      if (!continues) this.#past.push(this.#status);
      if (this.#past.length > HISTORY_LIMIT) this.#past.shift();
      this.#future = [];
      this.#openKey = undo ?? null;
    }
    const changed = this.#replace(next);
    if (undo !== false) for (const path of changed) this.#touched.add(path.split(".")[0]);
    return changed;
  }

  /** Put one value at a path. @param {string} path @param {unknown} value @param {SetOptions} [options] */
  setAt(path, value, options) {
    return this.set(/** @type {Part<Whole>} */ (partialAt(this.#status, path, value)), options);
  }

  /** @param {string} path @returns {unknown} */
  valueAt(path) {
    return valueAt(this.#status, path);
  }

  /** @param {string} path @returns {unknown} */
  defaultAt(path) {
    return valueAt(this.#defaults, path);
  }

  /** End a run of merged changes: the next one with the same key is a step of its own. */
  seal() {
    this.#openKey = null;
  }

  /** @returns {boolean} whether there was something to undo */
  undo() {
    return this.#step(this.#past, this.#future);
  }

  /** @returns {boolean} whether there was something to redo */
  redo() {
    return this.#step(this.#future, this.#past);
  }

  /** Steps that can be undone and redone, the last ones last. @returns {{ past: readonly Whole[], future: readonly Whole[] }} */
  get history() {
    return { past: [...this.#past], future: [...this.#future] };
  }

  /** Take up the steps of a page that was loaded again. @param {{ past: readonly Whole[], future: readonly Whole[] }} history */
  recall({ past, future }) {
    this.#past = past.map(deepFreeze);
    this.#future = future.map(deepFreeze);
    this.seal();
    this.#tell([]);
  }

  /** Forget all steps: what came before belongs to another mesh. */
  forget() {
    this.#past = [];
    this.#future = [];
    this.seal();
    this.#tell([]);
  }

  /**
   * @param {string} path a path, or "*" for every change
   * @param {(status: Whole, changed: readonly string[]) => void} listener
   * @returns {() => void} stops listening
   */
  on(path, listener) {
    const entry = { path, listener };
    this.#listeners.add(entry);
    return () => void this.#listeners.delete(entry);
  }

  /** @param {Whole[]} from @param {Whole[]} to */
  #step(from, to) {
    const target = from.pop();
    if (!target) return false;
    to.push(this.#status);
    this.seal();
    const { mesh } = /** @type {{ mesh?: unknown }} */ (this.#status);
    this.#replace({ ...target, mesh });
    return true;
  }

  /** @param {Whole} next */
  #replace(next) {
    const changed = changedPaths(this.#status, next);
    this.#status = deepFreeze(next);
    this.#tell(changed);
    return changed;
  }

  /** @param {readonly string[]} changed */
  #tell(changed) {
    const status = this.#status;
    for (const { path, listener } of [...this.#listeners]) {
      if (path === "*" || changed.some((one) => touches(path, one))) listener(status, changed);
    }
  }
}
