import { FILES, transact } from "./database.js";
import { allCaches, cacheNames } from "./names.js";

/**
 * What this browser keeps of the site beside meshes.
 *
 * @typedef {object} Lot
 * @property {"program" | "pages" | "last"} id
 * @property {string} name
 * @property {number} bytes
 * @property {number} count files
 */

/** @param {URL} root of the site @returns {Promise<Lot[]>} those of which something is here */
export async function inventory(root) {
  const { meshes, notes } = cacheNames(root.href);
  const names = await allCaches(root.href);
  const program = names.filter((name) => isProgram(name));
  const pages = names.filter((name) => !isProgram(name) && name !== meshes && name !== notes);
  const last = await lastFiles();
  /** @type {Lot[]} */
  const lots = [
    { id: "program", name: "Viewer, Python and the catalogue's shell", ...(await weighed(program)) },
    { id: "pages", name: "Pages, pictures and previews", ...(await weighed(pages)) },
    { id: "last", name: last.length ? `Your last file: ${last[0].path}` : "", ...sizeOf(last) },
  ];
  return lots.filter(({ count }) => count);
}

/** @param {URL} root @param {Lot["id"]} id */
export async function free(root, id) {
  if (id === "last") {
    await transact("readwrite", (store) => store.delete(FILES));
    return;
  }
  const { meshes, notes } = cacheNames(root.href);
  for (const name of await allCaches(root.href)) {
    if (id === "pages" && !isProgram(name) && name !== meshes && name !== notes) await caches.delete(name);
    if (id === "program" && isProgram(name)) await caches.delete(name);
  }
  if (id === "program") await unregister(root);
}

/** Let go of everything that the site keeps in this browser. @param {URL} root */
export async function freeEverything(root) {
  await unregister(root);
  for (const name of await allCaches(root.href)) await caches.delete(name);
  await transact("readwrite", (store) => store.clear()).catch(() => null);
}

/** @param {URL} root */
async function unregister(root) {
  const registration = await navigator.serviceWorker?.getRegistration(root.href);
  if (registration?.scope === root.href) await registration.unregister();
}

/** @param {string} cache of the versions, which workbox names */
function isProgram(cache) {
  return cache.startsWith("hexalab-precache");
}

/** @param {readonly string[]} names of caches */
async function weighed(names) {
  let bytes = 0;
  let count = 0;
  for (const name of names) {
    const cache = await caches.open(name);
    for (const request of await cache.keys()) {
      const response = await cache.match(request);
      bytes += (await response?.blob())?.size ?? 0;
      count += 1;
    }
  }
  return { bytes, count };
}

/** @returns {Promise<readonly import("./database.js").Found[]>} */
async function lastFiles() {
  const found = await transact("readonly", (store) => store.get(FILES)).catch(() => null);
  return /** @type {readonly import("./database.js").Found[]} */ (found ?? []);
}

/** @param {readonly import("./database.js").Found[]} found */
function sizeOf(found) {
  return { bytes: found.reduce((sum, { file }) => sum + file.size, 0), count: found.length };
}
