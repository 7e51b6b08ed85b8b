/**
 * Paths into the status document ("filters.peel.depth", "filters.planes.items.0.offset"), and the merging of
 * partial documents into whole ones. Arrays are values: a partial document replaces an array whole.
 *
 * @template T
 * @typedef {import("./status.js").Part<T>} Part
 */

/** @param {unknown} value @returns {value is Record<string, unknown>} */
export function isRecord(value) {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** What stands under a key of an object or a list. @param {unknown} value @param {string} key @returns {unknown} */
function partOf(value, key) {
  return value === null || value === undefined
    ? undefined
    : /** @type {Record<string, unknown>} */ (value)[key];
}

/** The value at a path, or undefined. @param {unknown} root @param {string} path @returns {unknown} */
export function valueAt(root, path) {
  return path.split(".").reduce(partOf, root);
}

/**
 * The smallest partial document that puts `value` at `path`. What lies below an array carries the whole array,
 * copied from `root`.
 *
 * @param {unknown} root @param {string} path @param {unknown} value @returns {unknown}
 */
export function partialAt(root, path, value) {
  return build(root, path.split("."), value);
}

/** @param {unknown} here @param {string[]} keys @param {unknown} value @returns {unknown} */
function build(here, keys, value) {
  if (!keys.length) return value;
  const [key, ...rest] = keys;
  if (Array.isArray(here)) {
    const copy = [...here];
    const index = Number(key);
    copy[index] = rest.length ? replaced(here[index], rest, value) : value;
    return copy;
  }
  return { [key]: build(partOf(here, key), rest, value) };
}

/** A whole copy of `here` with the value at `keys` replaced. @param {unknown} here @param {string[]} keys @param {unknown} value */
function replaced(here, keys, value) {
  return merge(here ?? {}, build(here ?? {}, keys, value));
}

/** @param {unknown} left @param {unknown} right @returns {boolean} */
export function equal(left, right) {
  if (Object.is(left, right)) return true;
  if (Array.isArray(left) && Array.isArray(right)) {
    return left.length === right.length && left.every((value, index) => equal(value, right[index]));
  }
  if (isRecord(left) && isRecord(right)) {
    const keys = Object.keys(left);
    return (
      keys.length === Object.keys(right).length &&
      keys.every((key) => key in right && equal(left[key], right[key]))
    );
  }
  return false;
}

/**
 * `base` with what `partial` holds. Parts that do not change keep their identity.
 *
 * @template T @param {T} base @param {unknown} partial @returns {T}
 */
export function merge(base, partial) {
  if (partial === undefined) return base;
  if (!isRecord(base) || !isRecord(partial)) return equal(base, partial) ? base : /** @type {T} */ (partial);
  /** @type {Record<string, unknown> | null} */
  let out = null;
  for (const [key, value] of Object.entries(partial)) {
    const merged = merge(base[key], value);
    if (merged === base[key]) continue;
    out ??= { ...base };
    out[key] = merged;
  }
  return /** @type {T} */ (out ?? base);
}

/** Paths of the leaves (arrays are leaves) in which two documents differ. @param {unknown} left @param {unknown} right @returns {string[]} */
export function changedPaths(left, right, prefix = "") {
  if (left === right) return [];
  if (!isRecord(left) || !isRecord(right)) return equal(left, right) ? [] : [prefix];
  const keys = new Set([...Object.keys(left), ...Object.keys(right)]);
  return [...keys].flatMap((key) => changedPaths(left[key], right[key], prefix ? `${prefix}.${key}` : key));
}

/**
 * What `document` holds beyond `base`: merging it into `base` gives `document`. Undefined where that is nothing.
 *
 * @template T @param {unknown} base @param {T} document @returns {Part<T> | undefined}
 */
export function difference(base, document) {
  if (equal(base, document)) return undefined;
  if (!isRecord(base) || !isRecord(document)) return /** @type {Part<T>} */ (document);
  /** @type {Record<string, unknown>} */
  const out = {};
  for (const key of Object.keys(document)) {
    const part = difference(base[key], document[key]);
    if (part !== undefined) out[key] = part;
  }
  return /** @type {Part<T>} */ (out);
}

/** Whether a change at `changed` concerns a listener at `path`. @param {string} path @param {string} changed */
export function touches(path, changed) {
  return path === "*" || path === changed || changed.startsWith(`${path}.`) || path.startsWith(`${changed}.`);
}

/** @template T @param {T} value @returns {T} */
export function deepFreeze(value) {
  if (typeof value === "object" && value !== null && !Object.isFrozen(value)) {
    Object.freeze(value);
    Object.values(value).forEach(deepFreeze);
  }
  return value;
}
