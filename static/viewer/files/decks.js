/**
 * Abaqus decks of several files that came together: which of these are shown, and which are parts of others.
 *
 * A part may be called anything: CalculiX' preprocessor writes the mesh of a deck as `all.msh`. Its name in the deck
 * decides, as the core reads it: `*INCLUDE`, `*NODE` and `*ELEMENT` with INPUT. That a part is missing, the core tells.
 */

/** @typedef {{ path: string }} Named */

/**
 * @template {Named} Some
 * @typedef {{ mesh: Some, parts: Some[] }} Whole a file that is shown, and what it may include
 */

/** @param {string} path */
const isDeck = (path) => /\.inp(\.gz)?$/i.test(path);

/**
 * @template {Named} Some
 * @param {readonly Some[]} files
 * @param {(path: string) => boolean} isMesh whether a file is a mesh by its name
 * @param {(file: Some) => Promise<string[]>} includesOf names in a file, as `includedBy` gives them
 * @returns {Promise<Whole<Some>[]>} as they came; no mesh is a part of another, unless they all are
 */
export async function wholes(files, isMesh, includesOf) {
  const meshes = files.filter(({ path }) => isMesh(path));
  const decks = files.length > 1 ? meshes.filter(({ path }) => isDeck(path)) : [];
  const named = byLastName(files);
  /** @type {Map<Some, Some[]>} */
  const links = new Map();
  const open = [...decks];
  for (const file of open) {
    if (links.has(file)) continue;
    const names = await includesOf(file);
    const found = names.flatMap((name) => meant(name, file, named.get(lastOf(name)) ?? []));
    const parts = [...new Set(found)].filter((part) => part !== file);
    links.set(file, parts);
    open.push(...parts);
  }
  const parts = new Set([...links.values()].flat());
  const whole = meshes.filter((mesh) => !parts.has(mesh));
  return (whole.length ? whole : meshes).map((mesh) => ({ mesh, parts: reached(mesh, links) }));
}

/** All that a file includes, and what that includes. @template Some @param {Some} file @param {Map<Some, Some[]>} links */
function reached(file, links) {
  const found = new Set([file]);
  for (const one of found) for (const part of links.get(one) ?? []) found.add(part);
  found.delete(file);
  return [...found];
}

/** The file at the path that a name tells, beside the file that names it; else all of that last name. @template {Named} Some @param {string} name @param {Named} from @param {Some[]} alike */
function meant(name, from, alike) {
  const folder = slashed(from.path).replace(/[^/]*$/, "");
  const there = alike.filter(({ path }) => slashed(path) === folder + slashed(name));
  return there.length ? there : alike;
}

/** @template {Named} Some @param {readonly Some[]} files @returns {Map<string, Some[]>} */
function byLastName(files) {
  const named = new Map();
  for (const file of files) named.set(lastOf(file.path), [...(named.get(lastOf(file.path)) ?? []), file]);
  return named;
}

/** @param {string} path */
const slashed = (path) =>
  path
    .replaceAll("\\", "/")
    .replace(/^(?:\.\/+)+/, "")
    .toLowerCase();

/** @param {string} path */
const lastOf = (path) => slashed(path).split("/").pop() ?? "";

/** A keyword with INPUT, on one line or on more, each of which goes on after a comma. */
const INPUT =
  /^[ \t]*\*(?!\*)(?:[^\r\n]*,[ \t]*\r?\n[ \t]*(?=[A-Z]))*[^\r\n]*?\bINPUT[ \t]*=[ \t]*("[^"\r\n]*"|'[^'\r\n]*'|[^,\r\n]*)/gim;

/** Names of the files that a deck includes. @param {string} text */
export function includedBy(text) {
  return [...text.matchAll(INPUT)].map(([, name]) => name.replace(/^["' \t]+|["' \t]+$/g, ""));
}

/** The text of lines: UTF-8 as tools of today write it, else Latin-1. @param {Uint8Array} bytes */
function decoded(bytes) {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder("latin1").decode(bytes);
  }
}

/** Bytes of a deck that are looked through, inflated if it is gzipped. */
const MOST = 2 ** 31;
const LONGEST_LINE = 2 ** 16;

/**
 * Names of the files that a deck includes, piece by piece: a deck may be larger than a text can be.
 *
 * @param {Blob} file
 * @param {string} path
 * @returns {Promise<string[]>}
 */
export async function includedIn(file, path) {
  /** @type {string[]} */
  const names = [];
  const gzipped = /\.gz$/i.test(path);
  const reader = (
    gzipped ? file.stream().pipeThrough(new DecompressionStream("gzip")) : file.stream()
  ).getReader();
  let held = new Uint8Array(); // a line that goes on in the next piece
  try {
    for (let read = 0; read < MOST; ) {
      const { done, value = new Uint8Array() } = await reader.read();
      read += value.length;
      const bytes = joined(held, value);
      const lines = done ? bytes.length : Math.max(bytes.lastIndexOf(10), bytes.lastIndexOf(13)) + 1;
      names.push(...includedBy(decoded(bytes.subarray(0, lines))));
      if (done) break;
      held = bytes.subarray(Math.max(lines, bytes.length - LONGEST_LINE));
    }
  } catch {
    return names; // that it can't be read is told when it is opened
  } finally {
    reader.cancel().catch(() => {});
  }
  return names;
}

/** @param {Uint8Array} first @param {Uint8Array} second */
function joined(first, second) {
  const both = new Uint8Array(first.length + second.length);
  both.set(first);
  both.set(second, first.length);
  return both;
}
