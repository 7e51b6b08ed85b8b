import { decimal } from "./numbers.js";

/**
 * The unit of length that a file's coordinates are in, as far as it was named (the status' `unit`). Numbers stay the file's
 * own: the unit is told beside them, and nothing is converted.
 *
 * @typedef {import("./status.js").Status["unit"]} LengthUnit
 * @typedef {{ readonly unit: LengthUnit }} Named  a status, or what of it counts here
 */

/** @type {Readonly<Record<LengthUnit, string>>} */
export const SYMBOLS = {
  none: "",
  nm: "nm",
  um: "µm",
  mm: "mm",
  cm: "cm",
  m: "m",
  km: "km",
  in: "in",
  ft: "ft",
};

/** Exponents, up to that of a volume's variance. */
const RAISED = ["", "", "²", "³", "⁴", "⁵", "⁶"];

/** Holds a number and its unit in one line. */
const NO_BREAK = "\u00a0";

/**
 * The unit of what is a power of a length: "mm", "mm²", "mm³"; empty where none was named, or where it is none.
 *
 * @param {Named} status @param {number} power
 */
export function unitOf({ unit }, power) {
  return power && SYMBOLS[unit] ? `${SYMBOLS[unit]}${RAISED[power]}` : "";
}

/** The same in letters that every program reads: "um^3". @param {Named} status @param {number} power */
export function plainUnitOf({ unit }, power) {
  return power && unit !== "none" ? `${unit}${power > 1 ? `^${power}` : ""}` : "";
}

/** Words for numbers with their unit behind them. @param {string} words @param {string} unit may be empty */
export function withUnit(words, unit) {
  return unit ? `${words}${NO_BREAK}${unit}` : words;
}

/** A number with its unit; what is not known or not finite has none. @param {number | null | undefined} value @param {string} unit may be empty */
export function measured(value, unit) {
  return withUnit(decimal(value), Number.isFinite(value) ? unit : "");
}

/** The name of an axis, a column, a legend: "Volume (mm³)". @param {string} name @param {string} unit may be empty */
export function titled(name, unit) {
  return unit ? `${name} (${unit})` : name;
}
