import { sha256 } from "../../offline/hash.js";

/**
 * Why the interpreter can't start, if one of its files is not what the site's list says: damaged on its way, or on the disk.
 * Copies that this browser keeps of it are thrown away, and it is fetched anew.
 *
 * @param {string} runtime address of the interpreter's folder, ending in a slash
 * @returns {Promise<string>} in words; empty if all files are whole, or it can't be told
 */
export async function damageInWords(runtime) {
  const list = await fetch(`${runtime}hashes.json`);
  if (!list.ok) return "";
  /** @type {Record<string, string>} */
  const hashes = await list.json();
  const words = [];
  for (const [file, expected] of Object.entries(hashes)) {
    const address = runtime + file;
    if (await isWhole(address, expected, "default")) continue;
    await forget(address);
    words.push(
      (await isWhole(address, expected, "reload"))
        ? `${file} was damaged on its way or on this disk, and has been fetched anew`
        : `${file} is damaged: its content is not what the site's list says`,
    );
  }
  return words.join("; ");
}

/** @param {string} address @param {string} expected SHA-256 @param {RequestCache} cache @returns {Promise<boolean>} true where it can't be told */
async function isWhole(address, expected, cache) {
  const response = await fetch(address, { cache });
  if (!response.ok) return true; // missing is not damaged
  const found = await sha256(await response.arrayBuffer());
  return found === "" || found === expected;
}

/** Throw away what the service worker keeps of a file. @param {string} address */
async function forget(address) {
  if (!("caches" in self)) return;
  for (const name of await caches.keys())
    if (name.startsWith("hexalab")) await (await caches.open(name)).delete(address, { ignoreSearch: true });
}
