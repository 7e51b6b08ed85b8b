/**
 * The catalogue's machine index for the viewer.
 *
 * @typedef {import("../state/entry.js").CatalogueSource} CatalogueSource
 * @typedef {import("../state/entry.js").Entry} Entry
 * @typedef {import("../state/entry.js").Index} Index
 *
 * @implements {Index}
 */
export class Catalogue {
  /** @type {readonly CatalogueSource[]} */
  sources;

  /** @param {{ sources: readonly CatalogueSource[] }} index @param {string} root address of the site's root: the index's addresses are relative to it */
  constructor(index, root) {
    const absolute = (/** @type {string | undefined} */ address) =>
      address ? new URL(address, root).href : address;
    this.sources = index.sources.map((source) => ({
      ...source,
      meshes: source.meshes.map((mesh) => ({
        ...mesh,
        url: /** @type {string} */ (absolute(mesh.url)),
        preview: absolute(mesh.preview),
        picture: absolute(mesh.picture),
      })),
    }));
  }

  /** @param {string} root */
  static async fetch(root) {
    const answer = await fetch(new URL("catalogue.json", root));
    if (!answer.ok)
      throw new Error(`the catalogue's index could not be fetched: ${answer.status} ${answer.statusText}`);
    return new Catalogue(await answer.json(), root);
  }

  /** @param {string} slug @returns {CatalogueSource | null} */
  source(slug) {
    return this.sources.find((source) => source.slug === slug) ?? null;
  }

  /** @param {string} source @param {string} mesh slugs @returns {Entry | null} */
  entry(source, mesh) {
    const found = this.source(source);
    const row = found?.meshes.find((one) => one.slug === mesh);
    return found && row ? { source: found, mesh: row } : null;
  }

  /** The mesh that a status document was made of. @param {{ sha256?: string, name?: string, cells?: number }} identity @returns {Entry | null} */
  identified({ sha256, name, cells }) {
    for (const source of this.sources) {
      for (const mesh of source.meshes) {
        const same =
          sha256 && mesh.sha256
            ? mesh.sha256 === sha256
            : Boolean(name) && mesh.cells === cells && mesh.url.endsWith(`/${name}`);
        if (same) return { source, mesh };
      }
    }
    return null;
  }

  /** The entry some steps further in the same source. @param {Entry} entry @param {number} step @returns {Entry | null} */
  beside(entry, step) {
    const { meshes } = entry.source;
    const at = meshes.findIndex((mesh) => mesh.slug === entry.mesh.slug) + step;
    return meshes[at] ? { source: entry.source, mesh: meshes[at] } : null;
  }
}
