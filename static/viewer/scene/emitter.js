/**
 * Listeners by event name.
 *
 * @template {object} Events what listeners of each event are told
 * @example
 * const off = emitter.on("camera", (camera) => store.set({ camera }));
 */
export class Emitter {
  /** @type {{ [Name in keyof Events]?: Set<(detail: Events[Name]) => void> }} */
  #listeners = {};

  /**
   * @template {keyof Events} Name
   * @param {Name} name
   * @param {(detail: Events[Name]) => void} listener
   * @returns {() => void} takes the listener off again
   */
  on(name, listener) {
    const listeners = (this.#listeners[name] ??= new Set());
    listeners.add(listener);
    return () => void listeners.delete(listener);
  }

  /**
   * @template {keyof Events} Name
   * @param {Name} name
   * @param {Events[Name]} detail
   */
  emit(name, detail) {
    for (const listener of [...(this.#listeners[name] ?? [])]) listener(detail);
  }

  clear() {
    this.#listeners = {};
  }
}
