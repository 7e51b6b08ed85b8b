import { CROSSING, chosenColour } from "../colours/structure.js";

/**
 * What of the structure is looked at (SPEC T), as pure steps on the status' section `structure`.
 *
 * @typedef {import("./status.js").Status["structure"]} Look
 * @typedef {Exclude<Look["kind"], "none">} Kind
 * @typedef {import("./status.js").PartialStatus} PartialStatus
 */

/** Whether blocks are drawn apart. @param {Partial<Look>} look */
export function isApart({ kind, form, explode = 0 }) {
  return kind === "blocks" && form !== "surfaces" && explode > 0;
}

/** How many times as large as the mesh its blocks stand. @param {Partial<Look>} look */
export function spreadOf(look) {
  return isApart(look) ? 1 + (look.explode ?? 0) : 1;
}

/** Which arcs or blocks are meant: of all irregular edges, or of those inside alone. @param {Look} look @param {string} kind @returns {"whole" | "interior"} */
export function variantOf({ boundary, complex }, kind) {
  if (kind === "arcs") return boundary ? "whole" : "interior";
  return kind === "blocks" ? complex : "whole";
}

/** What the cells are coloured by while things of a kind are looked at; the rest leaves colours as they are. @type {{ readonly [Name in Kind]?: "block" | "chosen" }} */
const COLOURED_BY = { blocks: "block", sheets: "chosen", chords: "chosen" };

/**
 * Look at things of a kind, or at none: with colours that tell them apart, which go again with them.
 *
 * @param {import("./status.js").Status} status @param {Look["kind"]} kind @param {readonly number[]} [chosen]
 * @returns {PartialStatus}
 */
export function lookAt({ colour, structure }, kind, chosen = []) {
  const by = kind === "none" ? undefined : COLOURED_BY[kind];
  const ours = colour.by === "block" || colour.by === "chosen";
  const coloured = by ? { colour: { by } } : ours ? { colour: { by: /** @type {const} */ ("sides") } } : {};
  const same = structure.kind === kind;
  return { structure: { kind, chosen: [...chosen], ...(same ? {} : { explode: 0 }) }, ...coloured };
}

/** Choose some of what is looked at. @param {readonly number[]} chosen @returns {PartialStatus} */
export function choose(chosen) {
  return { structure: { chosen: [...chosen] } };
}

/** What one and several things of a kind are called. @type {{ readonly [Name in Kind]: readonly [string, string] }} */
export const NAMES = {
  arcs: ["arc", "arcs"],
  sheets: ["sheet", "sheets"],
  chords: ["chord", "chords"],
  blocks: ["block", "blocks"],
};

/** "sheet 3", "sheets 3 and 17", "4 sheets". @param {Kind} kind @param {readonly number[]} chosen */
export function inWords(kind, chosen) {
  const [one, many] = NAMES[kind];
  if (chosen.length === 1) return `${one} ${chosen[0]}`;
  if (chosen.length === 2) return `${many} ${chosen[0]} and ${chosen[1]}`;
  return `${chosen.length} ${many}`;
}

/** "sheets 0, 1, 7, block 5"; empty where nothing is known of the cell. @param {import("./answers.js").CellStructure | null | undefined} structure */
export function cellInWords(structure) {
  if (!structure || structure.block === null) return "";
  const sheets = [...new Set(structure.sheets)];
  return `${NAMES.sheets[sheets.length > 1 ? 1 : 0]} ${sheets.join(", ")}, block ${structure.block}`;
}

/** Things that a legend names. */
const MOST_KEYS = 6;

/** What the colours of what was chosen mean. @param {Look} look @returns {{ name: string, colour: string }[]} */
export function chosenKeys({ kind, chosen }) {
  if (kind === "none" || kind === "arcs") return [];
  const keys = chosen
    .slice(0, MOST_KEYS)
    .map((number, place) => ({ name: `${NAMES[kind][0]} ${number}`, colour: chosenColour(place) }));
  return kind !== "blocks" && chosen.length > 1 ? [...keys, { name: "in several", colour: CROSSING }] : keys;
}
