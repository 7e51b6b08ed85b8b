/** Levels of lists and objects that a document may have; ours has six. */
const DEEPEST = 64;

/** Values in a document: a list of every cell of a large mesh has room. */
const LARGEST = 5_000_000;

/**
 * A copy of a value out of what JSON holds alone: lists, objects, texts, numbers, truth values and null. What comes from
 * scripts, links, files and the clipboard is made plain before it goes anywhere: it may be a proxy, have getters, go in
 * circles, or be nested so deep that whoever reads it runs out of stack.
 *
 * @param {unknown} value @param {string} what names it in errors
 * @returns {unknown}
 * @throws {Error} what in it is no such value, and where
 */
export function plain(value, what = "the settings") {
  let left = LARGEST;

  /** @param {unknown} one @param {string} path @param {number} depth @returns {unknown} */
  function copy(one, path, depth) {
    if (--left < 0) throw new Error(`${what} hold more than ${LARGEST.toLocaleString("en-GB")} values`);
    if (one === null || typeof one === "boolean" || typeof one === "string") return one;
    if (typeof one === "number") return Number.isFinite(one) ? one : null;
    if (typeof one !== "object") throw new Error(`${what} hold a ${typeof one} at ${path || "the top"}`);
    if (depth === DEEPEST) throw new Error(`${what} are nested more than ${DEEPEST} deep`);
    if (Array.isArray(one) || ArrayBuffer.isView(one))
      return Array.from(/** @type {ArrayLike<unknown>} */ (/** @type {unknown} */ (one)), (entry, index) =>
        copy(entry, `${path}[${index}]`, depth + 1),
      );
    /** @type {Record<string, unknown>} */
    const out = {};
    for (const key of Object.keys(one)) {
      const entry = /** @type {Record<string, unknown>} */ (one)[key];
      if (entry !== undefined)
        Object.defineProperty(out, key, {
          value: copy(entry, path ? `${path}.${key}` : key, depth + 1),
          enumerable: true,
          configurable: true,
          writable: true,
        });
    }
    return out;
  }

  try {
    return copy(value, "", 0);
  } catch (cause) {
    const reason = cause instanceof Error ? cause.message : String(cause);
    if (reason.startsWith(what)) throw cause;
    throw new Error(`${what} can't be read: ${reason}`, { cause });
  }
}
