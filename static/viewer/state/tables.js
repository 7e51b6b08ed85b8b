/**
 * The core's tables as the page carries them (a JSON block that the site builder writes from the core): nothing of
 * them is written a second time in JavaScript.
 *
 * @typedef {object} MetricRow
 * @property {string} id
 * @property {string} name
 * @property {string} symbol
 * @property {string} variant which of several that go by the name; may be empty
 * @property {"high" | "low"} better
 * @property {number} length_power power of a length that values carry: 3 for a volume
 * @property {readonly [number | null, number | null]} full_range null: unbounded
 * @property {readonly [number | null, number | null] | null} acceptable_range
 *
 * @typedef {object} ComparedRow
 * @property {string} id
 * @property {string} name
 * @property {"high" | "low"} better
 * @property {number} length_power
 * @property {string} metric whose change it is; empty of what has no sign
 * @property {boolean} cellwise whether it needs the same cells in both meshes
 *
 * @typedef {{ id: string, name: string, extensions: readonly string[] }} FormatRow
 *
 * @typedef {{ id: string, name: string, extension: string }} WriterRow
 *
 * @typedef {import("./status.js").Choices} Choices
 * @typedef {import("./answers.js").Statistics} Statistics
 * @typedef {{ [Name in keyof Statistics]: Statistics[Name] extends number | null ? Name : never }[keyof Statistics]} NumberName
 *
 * @typedef {object} Tables
 * @property {string} version of the program
 * @property {import("./status.js").Status} defaults the status document's
 * @property {readonly string[]} core_paths settings that concern the core
 * @property {{ readonly [Path in keyof Choices]: readonly Choices[Path][] }} choices words that a setting takes, by its path
 * @property {Readonly<Record<string, readonly [number, number]>>} limits of a setting that is a number between two
 * @property {readonly string[]} described parts of a mesh's description, the quick ones first
 * @property {readonly NumberName[]} statistics names of those that the catalogue holds
 * @property {readonly MetricRow[]} metrics
 * @property {readonly { id: string, name: string }[]} traced numbers per cell that come out of the structure
 * @property {readonly ComparedRow[]} compared numbers per cell that come out of a comparison
 * @property {readonly FormatRow[]} formats
 * @property {readonly FormatRow[]} surfaces formats of reference surfaces
 * @property {readonly WriterRow[]} writers
 * @property {readonly { id: string, name: string }[]} list_forms forms that cells are copied in
 * @property {number} most_at_once shown cells up to which all sheets or chords are drawn as surfaces and curves, where none is chosen
 */

/** @param {Document} page @returns {Tables} */
export function readTables(page) {
  const block = page.getElementById("core-tables");
  if (!block?.textContent) throw new Error("this page lacks its tables; build it with `hexalab build`");
  return JSON.parse(block.textContent);
}

/** A number per cell out of the structure. @param {Tables} tables @param {string} id */
export function tracedOf(tables, id) {
  return tables.traced.find((one) => one.id === id);
}

/** A number per cell out of a comparison. @param {Pick<Tables, "compared">} tables @param {string} id */
export function comparedOf(tables, id) {
  return tables.compared.find((one) => one.id === id);
}

/** @param {Tables} tables @param {string} id */
export function metricOf(tables, id) {
  return tables.metrics.find((metric) => metric.id === id);
}
