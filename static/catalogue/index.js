import { compare } from "./sorting.js";

/**
 * @typedef {object} Source
 * @property {string} slug
 * @property {string} title
 * @property {string} authors
 * @property {number} year
 * @property {string} venue
 * @property {string} doi
 * @property {string} short who and when
 */

/**
 * @typedef {object} Row a mesh as the search knows it
 * @property {Source} source
 * @property {string} slug
 * @property {string} name
 * @property {number | null} cells
 * @property {number | null} low smallest Scaled Jacobian
 * @property {number | null} mean
 * @property {number | null} high
 * @property {number | null} irregular number of irregular interior edges
 * @property {boolean} picture
 * @property {string} codes its option in each facet, a digit each
 * @property {string} text what a word is looked for in
 */

/**
 * @typedef {object} Index
 * @property {{ id: string, options: string[] }[]} facets
 * @property {Row[]} rows
 */

/**
 * Unpack search.json.
 *
 * @param {any} data
 * @returns {Index}
 */
export function readIndex(data) {
  /** @type {Source[]} */
  const sources = data.sources.map((/** @type {any[]} */ row) => {
    const [slug, title, authors, year, venue, doi, short] = row;
    return { slug, title, authors, year, venue, doi, short };
  });
  const rows = data.meshes.map((/** @type {any[]} */ row) => {
    const [number, slug, name, cells, low, mean, high, irregular, picture, codes, description = ""] = row;
    const source = sources[number];
    const words = [name, description, source.title, source.authors, source.year, source.venue, source.doi];
    return {
      source, slug, name, cells, low, mean, high, irregular, codes,
      picture: picture === 1,
      text: plain(words.join(" ")),
    }; // prettier-ignore
  });
  return { facets: data.facets, rows };
}

/**
 * Lower case, without accents: what a reader types and what is written meet there.
 *
 * @param {string} text
 */
export function plain(text) {
  return text.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();
}

/**
 * @typedef {object} Query
 * @property {string} words
 * @property {string} source slug, or "" for all
 * @property {string} sort
 * @property {Record<string, string[]>} chosen options by facet; none chosen means all
 */

/**
 * The rows that a query finds, in its order, and what each further choice would find.
 *
 * @param {Index} index
 * @param {Query} query
 * @returns {{ rows: Row[], counts: number[][] }}
 */
export function find(index, query) {
  const words = plain(query.words).split(/\s+/).filter(Boolean);
  const wanted = index.facets.map(({ id, options }) => {
    const chosen = query.chosen[id] ?? [];
    return chosen.length ? options.map((option) => chosen.includes(option)) : null;
  });
  const counts = index.facets.map(({ options }) => options.map(() => 0));
  const rows = [];
  for (const row of index.rows) {
    if (query.source && row.source.slug !== query.source) continue;
    if (!words.every((word) => row.text.includes(word))) continue;
    const missed = wanted.flatMap((options, facet) =>
      options === null || options[Number(row.codes[facet])] ? [] : [facet],
    );
    if (missed.length === 0) {
      rows.push(row);
      counts.forEach((options, facet) => options[Number(row.codes[facet])]++);
    } else if (missed.length === 1) {
      counts[missed[0]][Number(row.codes[missed[0]])]++;
    }
  }
  return { rows: sorted(rows, query.sort), counts };
}

/** @type {Record<string, (row: Row) => string | number | null>} */
const KEYS = {
  name: (row) => row.name,
  year: (row) => -row.source.year,
  cells: (row) => row.cells,
  sj: (row) => row.low,
  irregular: (row) => row.irregular,
};

/**
 * @param {Row[]} rows
 * @param {string} sort a key, with a minus before it for the largest first; "" leaves the order
 */
function sorted(rows, sort) {
  const down = sort.startsWith("-");
  const key = KEYS[down ? sort.slice(1) : sort];
  return key ? [...rows].sort((a, b) => compare(key(a), key(b), down)) : rows;
}
