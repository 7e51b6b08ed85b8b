/**
 * What is known at the moment and is not a setting: the mesh's summary, what the core is doing, which cell is
 * inspected, messages. Panels listen to single facts by name.
 *
 *     facts.on("summary", (summary) => show(summary));
 *     facts.set({ summary });
 */
export class Facts {
  /** @type {Map<string, any>} */ #values = new Map();
  /** @type {Map<string, Set<(value: any) => void>>} */ #listeners = new Map();

  /** @param {Record<string, any>} [initial] */
  constructor(initial = {}) {
    for (const [name, value] of Object.entries(initial)) this.#values.set(name, value);
  }

  /** @param {string} name @returns {any} */
  get(name) {
    return this.#values.get(name);
  }

  /** @param {Record<string, any>} values */
  set(values) {
    const changed = Object.entries(values).filter(
      ([name, value]) => !Object.is(this.#values.get(name), value),
    );
    for (const [name, value] of changed) this.#values.set(name, value);
    for (const [name, value] of changed) {
      for (const listener of [...(this.#listeners.get(name) ?? [])]) listener(value);
    }
  }

  /** @param {string} name @param {(value: any) => void} listener @returns {() => void} stops listening */
  on(name, listener) {
    const all = this.#listeners.get(name) ?? new Set();
    this.#listeners.set(name, all.add(listener));
    return () => void all.delete(listener);
  }
}
