/**
 * Paths into the status document ("filters.peel.depth", "filters.planes.items.0.offset"), and the merging of
 * partial documents into whole ones. Arrays are values: a partial document replaces an array whole.
 *
 * @typedef {null | boolean | number | string | readonly any[] | { readonly [key: string]: any }} Json
 */

/** @param {unknown} value @returns {value is Record<string, any>} */
export function isRecord(value) {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** The value at a path, or undefined. @param {any} root @param {string} path @returns {any} */
export function valueAt(root, path) {
  let value = root;
  for (const key of path.split(".")) {
    if (value === null || value === undefined) return undefined;
    value = value[key];
  }
  return value;
}

/**
 * The smallest partial document that puts `value` at `path`. What lies below an array carries the whole array,
 * copied from `root`.
 *
 * @param {any} root @param {string} path @param {any} value @returns {any}
 */
export function partialAt(root, path, value) {
  return build(root, path.split("."), value);
}

/** @param {any} here @param {string[]} keys @param {any} value @returns {any} */
function build(here, keys, value) {
  if (!keys.length) return value;
  const [key, ...rest] = keys;
  if (Array.isArray(here)) {
    const copy = [...here];
    const index = Number(key);
    copy[index] = rest.length ? replaced(here[index], rest, value) : value;
    return copy;
  }
  return { [key]: build(here?.[key], rest, value) };
}

/** A whole copy of `here` with the value at `keys` replaced. @param {any} here @param {string[]} keys @param {any} value */
function replaced(here, keys, value) {
  return merge(here ?? {}, build(here ?? {}, keys, value));
}

/** @param {any} left @param {any} right @returns {boolean} */
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
 * @template T @param {T} base @param {any} partial @returns {T}
 */
export function merge(base, partial) {
  if (partial === undefined) return base;
  if (!isRecord(base) || !isRecord(partial)) return equal(base, partial) ? base : partial;
  /** @type {Record<string, any> | null} */
  let out = null;
  for (const [key, value] of Object.entries(partial)) {
    const merged = merge(base[key], value);
    if (merged === base[key]) continue;
    out ??= { ...base };
    out[key] = merged;
  }
  return /** @type {T} */ (out ?? base);
}

/** Paths of the leaves (arrays are leaves) in which two documents differ. @param {any} left @param {any} right @returns {string[]} */
export function changedPaths(left, right, prefix = "") {
  if (left === right) return [];
  if (!isRecord(left) || !isRecord(right)) return equal(left, right) ? [] : [prefix];
  const keys = new Set([...Object.keys(left), ...Object.keys(right)]);
  return [...keys].flatMap((key) => changedPaths(left[key], right[key], prefix ? `${prefix}.${key}` : key));
}

/** What `document` holds beyond `base`: merging it into `base` gives `document`. @param {any} base @param {any} document @returns {any} */
export function difference(base, document) {
  if (equal(base, document)) return undefined;
  if (!isRecord(base) || !isRecord(document)) return document;
  /** @type {Record<string, any>} */
  const out = {};
  for (const key of Object.keys(document)) {
    const part = difference(base[key], document[key]);
    if (part !== undefined) out[key] = part;
  }
  return out;
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
