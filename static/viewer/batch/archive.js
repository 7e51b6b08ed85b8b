import { includedIn, wholes } from "../files/decks.js";
import { stemOf } from "../files/names.js";

/**
 * The meshes in an archive, each with the parts that it includes and the settings beside it.
 *
 * @typedef {import("../files/zip.js").Entry} Entry
 * @typedef {{ mesh: Entry, parts: Entry[] }} WholeEntry
 * @typedef {{ name: string, bytes: () => Promise<ArrayBuffer>, companions?: () => Promise<Record<string, ArrayBuffer>> }} EntryOrigin
 * @typedef {readonly { extensions: readonly string[] }[]} Formats
 */

/** @template {{ name: string }} Some @param {Some[]} entries @param {Formats} formats @returns {Some[]} the meshes among them */
export function meshesOf(entries, formats) {
  const extensions = formats.flatMap((format) => format.extensions);
  return entries.filter(({ name }) => {
    const file = name.split("/").pop() ?? "";
    const plain = file.toLowerCase().replace(/\.gz$/, "");
    return (
      !file.startsWith(".") && !name.startsWith("__MACOSX/") && extensions.some((end) => plain.endsWith(end))
    );
  });
}

/** @param {Entry[]} entries @param {Formats} formats @returns {Promise<WholeEntry[]>} */
export async function meshesIn(entries, formats) {
  const files = entries.map((entry) => ({ entry, path: entry.name }));
  const isMesh = (/** @type {string} */ path) => meshesOf([{ name: path }], formats).length > 0;
  const found = await wholes(files, isMesh, async ({ entry }) =>
    includedIn(new Blob([await entry.read()]), entry.name),
  );
  return found.map(({ mesh, parts }) => ({ mesh: mesh.entry, parts: parts.map(({ entry }) => entry) }));
}

/** Where a mesh comes from; by its path if it includes others, by its last name else. @param {WholeEntry} whole @returns {EntryOrigin} */
export function originIn({ mesh, parts }) {
  const bytes = async () => (await mesh.read()).buffer;
  if (!parts.length) return { name: mesh.name.split("/").pop() ?? mesh.name, bytes };
  const read = async (/** @type {Entry} */ part) => [part.name, (await part.read()).buffer];
  return {
    name: mesh.name,
    bytes,
    companions: async () => Object.fromEntries(await Promise.all(parts.map(read))),
  };
}

/** The status beside a mesh, if there is one. @param {Entry} mesh @param {Entry[]} entries @returns {Promise<unknown[]>} */
export async function settingsBeside(mesh, entries) {
  const stem = stemOf(mesh.name);
  const own = entries.find(({ name }) => name === `${stem}.json` || name === `${stem}.txt`);
  if (!own) return [];
  try {
    return [JSON.parse(new TextDecoder().decode(await own.read()))];
  } catch (cause) {
    throw new Error(`${own.name}, beside it, holds no settings: ${/** @type {Error} */ (cause).message}`, {
      cause,
    });
  }
}
