/**
 * Names of what this site keeps in the browser. An origin may hold several sites, each below a path of its own, and other
 * programs beside them: a name carries the address of the site's root.
 */

/** @param {string} root whole address of the site's root, ending in a slash */
export function cacheNames(root) {
  const named = (/** @type {string} */ what) => `hexalab ${what} ${root}`;
  return {
    /** Pages that were visited, and the catalogue's lists. */
    pages: named("pages"),
    /** Pictures and previews that were seen. */
    pictures: named("pictures"),
    /** Meshes that were opened, and those that are to be kept. */
    meshes: named("meshes"),
    /** Pages, pictures and previews that are to be kept. */
    kept: named("kept"),
    /** What the service worker has to remember. */
    notes: named("notes"),
  };
}

/** Names of all caches of the site, those of its versions too. @param {string} root @returns {Promise<string[]>} */
export async function allCaches(root) {
  return (await caches.keys()).filter((name) => name.startsWith("hexalab") && name.endsWith(root));
}
