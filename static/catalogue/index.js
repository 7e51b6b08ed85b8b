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
 * @property {number | null} sheets
 * @property {number | null} blocks
 * @property {string} picture ending of its picture's file, "" if there is none
 * @property {string} codes its option in each facet, a digit of base 36 each
 * @property {string} model title of the body that it is a mesh of, "" if none is known
 * @property {number} validity its option in the facet of that name, -1 where there is none
 * @property {string} text what a word is looked for in
 * @property {string} joined the same without what parts words: "rocker_arm", "rocker arm" and "rockerarm" meet there
 */

/**
 * @typedef {object} Index
 * @property {{ id: string, options: string[] }[]} facets
 * @property {string[]} models titles
 * @property {Row[]} rows
 */

/** Endings of pictures, as search.json numbers them. */
const PICTURES = ["", "png", "webp"];

/** A row's option in a facet. @param {string} codes @param {number} facet */
function option(codes, facet) {
  return Number.parseInt(codes[facet], 36);
}

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
  /** @type {string[]} */
  const models = data.models ?? [];
  const validity = data.facets.findIndex((/** @type {{ id: string }} */ facet) => facet.id === "validity");
  const rows = data.meshes.map((/** @type {any[]} */ row) => {
    const [number, slug, name, cells, low, mean, high, irregular, picture, codes, description = ""] = row;
    const [sheets = null, blocks = null, body = null] = row.slice(11);
    const model = body === null ? "" : models[body];
    const source = sources[number];
    const words = [
      name,
      model,
      description,
      source.title,
      source.authors,
      source.year,
      source.venue,
      source.doi,
    ];
    const text = plain(words.join(" "));
    return {
      source, slug, name, cells, low, mean, high, irregular, sheets, blocks, codes, model,
      picture: PICTURES[picture],
      validity: validity < 0 ? -1 : option(codes, validity),
      text,
      joined: joined(text),
    }; // prettier-ignore
  });
  return { facets: data.facets, models, rows };
}

/**
 * Lower case, without accents: what a reader types and what is written meet there.
 *
 * @param {string} text
 */
export function plain(text) {
  return text.normalize("NFKD").replace(/\p{M}/gu, "").toLowerCase();
}

/** Without what parts words and what is written between them. @param {string} text */
function joined(text) {
  return text.replace(/[^\p{L}\p{N}]+/gu, "");
}

/**
 * @typedef {object} Query
 * @property {string} words
 * @property {string} source slug, or "" for all
 * @property {string} model a part of a body's title, or "" for all
 * @property {string} sort
 * @property {Record<string, string[]>} chosen options by facet; none chosen means all
 */

/**
 * The rows that a query finds, in its order, and what each further choice would find. Where no text has all its words, those
 * that differ by a letter count.
 *
 * @param {Index} index
 * @param {Query} query
 * @returns {{ rows: Row[], counts: number[][], forgiven: boolean }} forgiven: whether a letter was
 */
export function find(index, query) {
  const words = plain(query.words).split(/\s+/).filter(Boolean);
  const exact = index.rows.filter((row) => words.every((word) => has(row, word)));
  const forgiven = words.length > 0 && !exact.length;
  const rows = forgiven ? index.rows.filter((row) => words.every((word) => hasLike(row, word))) : exact;
  return { ...narrowed(rows, index, query), forgiven: forgiven && rows.length > 0 };
}

/** @param {Row} row @param {string} word */
function has(row, word) {
  const plainly = joined(word);
  return row.text.includes(word) || (plainly.length > 2 && row.joined.includes(plainly));
}

/** Letters from which on one of a word may be wrong. */
const LONG = 4;

/** @param {Row} row @param {string} word */
function hasLike(row, word) {
  if (has(row, word)) return true;
  if (word.length < LONG) return false;
  return row.text.split(/[^\p{L}\p{N}]+/u).some((one) => differByALetter(one, word));
}

/**
 * Whether two words are the same but for one letter that is missing, too many, another, or has changed places with the next; of
 * a longer word its beginning counts.
 *
 * @param {string} there @param {string} typed
 */
export function differByALetter(there, typed) {
  if (there.length < typed.length - 1) return false;
  let k = 0;
  while (k < typed.length && there[k] === typed[k]) k++;
  const rest = typed.slice(k);
  return [
    there.slice(k + 1).startsWith(rest.slice(1)) && rest.length > 0, // another letter
    there.slice(k).startsWith(rest.slice(1)), // one too many
    there.slice(k + 1).startsWith(rest), // one is missing
    rest.length > 1 && there.slice(k).startsWith(rest[1] + rest[0] + rest.slice(2)),
  ].some(Boolean);
}

/** @param {Row[]} found @param {Index} index @param {Query} query */
function narrowed(found, index, query) {
  const wanted = index.facets.map(({ id, options }) => {
    const chosen = query.chosen[id] ?? [];
    return chosen.length ? options.map((option) => chosen.includes(option)) : null;
  });
  const counts = index.facets.map(({ options }) => options.map(() => 0));
  const ofModel = modelTest(query.model, index.models);
  const rows = [];
  for (const row of found) {
    if (query.source && row.source.slug !== query.source) continue;
    if (!ofModel(row.model)) continue;
    const missed = wanted.flatMap((options, facet) =>
      options === null || options[option(row.codes, facet)] ? [] : [facet],
    );
    if (missed.length === 0) {
      rows.push(row);
      counts.forEach((options, facet) => options[option(row.codes, facet)]++);
    } else if (missed.length === 1) {
      counts[missed[0]][option(row.codes, missed[0])]++;
    }
  }
  return { rows: sorted(rows, query.sort), counts };
}

/**
 * Whether a body is meant: the one of that title, or, where none has it, each that has it as a part.
 *
 * @param {string} typed @param {string[]} titles
 * @returns {(title: string) => boolean}
 */
function modelTest(typed, titles) {
  const wanted = joined(plain(typed));
  if (!wanted) return () => true;
  const spelled = (/** @type {string} */ title) => joined(plain(title));
  if (titles.some((title) => spelled(title) === wanted)) return (title) => spelled(title) === wanted;
  return (title) => spelled(title).includes(wanted);
}

/** @type {Record<string, (row: Row) => string | number | null>} */
const KEYS = {
  name: (row) => row.name,
  year: (row) => -row.source.year,
  cells: (row) => row.cells,
  sj: (row) => row.low,
  irregular: (row) => row.irregular,
  blocks: (row) => row.blocks,
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
