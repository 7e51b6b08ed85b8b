import { difference, isRecord, partialAt, valueAt } from "./paths.js";

/**
 * @template T
 * @typedef {import("./status.js").Part<T>} Part
 */

/**
 * What the core knows of the status: the settings that concern it, as they were told last. It is told what differs.
 *
 *     const settings = new CoreSettings(tables.core_paths);
 *     if (settings.concern(changed)) await client.call("update", () => [settings.changed(store.status), false]);
 */
export class CoreSettings {
  #paths;
  /** The status of which the core knows its part; null when it is to be told all. @type {object | null} */
  #told = null;

  /** @param {readonly string[]} paths of the settings that concern the core, as the schema marks them */
  constructor(paths) {
    this.#paths = paths;
  }

  /** Whether any of these changes concerns the core. @param {readonly string[]} changed paths */
  concern(changed) {
    return changed.some((path) => this.#paths.some((one) => path === one || path.startsWith(`${one}.`)));
  }

  /**
   * What the core has to be told of a status; from now on it counts as told.
   *
   * @template {object} Whole @param {Whole} status
   * @returns {Part<Whole>} a partial document of settings that concern the core
   */
  changed(status) {
    /** @type {unknown} */
    let partial = {};
    for (const path of this.#paths) {
      const value = valueAt(status, path);
      const part = this.#told ? difference(valueAt(this.#told, path), value) : value;
      if (part !== undefined) partial = joined(partial, partialAt(status, path, part));
    }
    this.#told = status;
    return /** @type {Part<Whole>} */ (partial);
  }

  /** The core has opened another mesh, or a call failed: what it has taken on is not known, so that it is told all. */
  forget() {
    this.#told = null;
  }
}

/** Two partial documents of different paths as one. @param {unknown} one @param {unknown} other @returns {unknown} */
function joined(one, other) {
  if (!isRecord(one) || !isRecord(other)) return other;
  const out = { ...one };
  for (const [key, value] of Object.entries(other)) out[key] = key in out ? joined(out[key], value) : value;
  return out;
}
