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
    /** Meshes that were opened. */
    meshes: named("meshes"),
    /** What the service worker has to remember. */
    notes: named("notes"),
  };
}
