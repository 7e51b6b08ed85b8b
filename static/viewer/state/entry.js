/**
 * What the catalogue tells of its sources and their meshes, as its machine index has it.
 *
 * @typedef {object} CatalogueMesh
 * @property {string} slug
 * @property {string} name
 * @property {number | null} cells
 * @property {string} url
 * @property {boolean} remote
 * @property {number | null} [bytes]
 * @property {string | null} [sha256]
 * @property {string} [preview] address of its summary and first picture
 * @property {string} [picture] address of its portrait, where it lies elsewhere and has to be fetched first
 * @property {import("./status.js").PartialStatus} [view] what it opens with, and what preview and portrait were made under
 *
 * @typedef {object} CatalogueSource  a publication
 * @property {string} slug
 * @property {string} title
 * @property {readonly string[]} authors
 * @property {number} [year]
 * @property {string} [venue]
 * @property {string} [doi]
 * @property {string} [pdf]
 * @property {string} [web]
 * @property {readonly CatalogueMesh[]} meshes
 *
 * @typedef {{ source: CatalogueSource, mesh: CatalogueMesh }} Entry
 *
 * @typedef {object} Index  where sources and meshes are looked up
 * @property {readonly CatalogueSource[]} sources
 * @property {(slug: string) => CatalogueSource | null} source
 * @property {(source: string, mesh: string) => Entry | null} entry by slugs
 * @property {(identity: { sha256?: string, name?: string, cells?: number }) => Entry | null} identified
 * @property {(entry: Entry, step: number) => Entry | null} beside
 */

/** Authors that a short reference names. */
const FEW = 2;

/**
 * A reference in one line.
 *
 * @param {CatalogueSource} source @param {boolean} [short] one name for more than two
 */
export function inOneLine({ authors, year, title, venue }, short = false) {
  const [first = "", ...others] = authors;
  const who =
    short && authors.length > FEW
      ? `${first} et al.`
      : authors.length > FEW
        ? `${authors.slice(0, -1).join(", ")} and ${authors[authors.length - 1]}`
        : [first, ...others].join(" and ");
  return `${[who, year && `(${year})`].filter(Boolean).join(" ")}: ${title}${venue ? `, ${venue}` : ""}.`;
}
