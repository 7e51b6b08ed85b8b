/**
 * What belongs together and is kept together: meshes with their pages, pictures and previews.
 *
 * @typedef {object} Item  a mesh
 * @property {string} name
 * @property {string} address of its file
 * @property {number | null} bytes null where nobody has measured them
 * @property {string} sha256 of the file, or empty where it is not known
 *
 * @typedef {object} Parcel  all addresses are whole
 * @property {Item[]} meshes
 * @property {string[]} pages with the pictures that they show
 * @property {string[]} previews
 *
 * @typedef {object} CatalogueRow  of a mesh, as `catalogue.json` has it
 * @property {string} slug
 * @property {string} name
 * @property {string} url
 * @property {number | null} [bytes]
 * @property {string | null} [sha256]
 * @property {string} [preview]
 */

/**
 * The parcel of a source, or of a single mesh of it.
 *
 * @param {{ slug: string, meshes: readonly CatalogueRow[] }} source @param {string} mesh slug of one, or empty for all @param {string} root of the site
 * @returns {Parcel}
 */
export function parcelOf(source, mesh, root) {
  const absolute = (/** @type {string} */ address) => new URL(address, root).href;
  const rows = source.meshes.filter(({ slug }) => !mesh || slug === mesh);
  const page = `sources/${source.slug}/`;
  return {
    meshes: rows.map(({ name, url, bytes = null, sha256 }) => ({
      name,
      address: absolute(url),
      bytes,
      sha256: sha256 ?? "",
    })),
    pages: [
      ...(mesh ? [] : [absolute(`${page}index.html`)]),
      ...rows.map(({ slug }) => absolute(`${page}${slug}/index.html`)),
    ],
    previews: rows.flatMap(({ preview }) => (preview ? [absolute(preview)] : [])),
  };
}

/** The sources of the catalogue. @param {URL} root of the site @returns {Promise<{ slug: string, meshes: CatalogueRow[] }[]>} @throws {Error} its list can't be had */
export async function fetchSources(root) {
  const answer = await fetch(new URL("catalogue.json", root));
  if (!answer.ok) throw new Error(`The catalogue's list could not be fetched: ${answer.status}`);
  return (await answer.json()).sources;
}
