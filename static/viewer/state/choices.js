import { SYMBOLS } from "./units.js";

/**
 * What the words of the settings are called on the screen. Which words there are, and in which order, says the schema.
 *
 * @typedef {import("./status.js").Choices} Choices
 * @typedef {import("./tables.js").Tables} Tables
 */

const CORNERS = {
  bottom_left: "below, left",
  bottom_right: "below, right",
  top_left: "above, left",
  top_right: "above, right",
};

/** @type {{ readonly [Path in keyof Choices]: Readonly<Record<Choices[Path], string>> }} */
const NAMES = {
  unit: { ...SYMBOLS, none: "not named" },
  "camera.projection": { perspective: "Perspective", orthographic: "Orthographic" },
  "filters.planes.rule": { barycentre: "hide by barycentre", any_corner: "hide by any corner" },
  "separation.mode": {
    lines: "Lines",
    darkness_coded_edges: "Darkness-coded edges",
    fissure: "Fissure",
    rounded: "Rounded",
  },
  "colour.by": {
    sides: "Outside and inside",
    quality: "Quality",
    attribute: "Attribute",
    kind: "Cell kind",
    part: "Part",
    group: "Group",
    block: "Block",
    chosen: "What is chosen",
  },
  "colour.map": {
    parula: "Parula",
    viridis: "Viridis",
    jet: "Jet",
    red_blue: "Red-Blue",
    diverging: "Diverging",
  },
  "see_through.cells": {
    none: "nothing",
    all: "all that is hidden",
    cut: "what slice and peel hide",
    quality: "what the quality filter hides",
    parts: "hidden parts",
    groups: "hidden groups",
    structure: "what is hidden by structure",
    picking: "what was hidden by hand",
  },
  "filters.structure.keep": { inside: "cells in any of them", outside: "cells in none of them" },
  "filters.structure.complex": { whole: "all irregular edges", interior: "those inside alone" },
  "structure.kind": { none: "Off", arcs: "Arcs", sheets: "Sheets", chords: "Chords", blocks: "Blocks" },
  "structure.form": { cells: "Cells", surfaces: "Surfaces" },
  "compare.layout": { beside: "Side by side", curtain: "Curtain" },
  "compare.camera": { auto: "as fits", own: "each in its own frame", same: "at the same place" },
  "compare.colours": { common: "common to both", own: "each its own" },
  "structure.complex": { whole: "all irregular edges", interior: "those inside alone" },
  "irregular.palette": { standard: "standard", colour_blind: "for colour-blind eyes" },
  "lighting.mode": {
    object_space_ao: "AO, best",
    screen_space_ao: "AO, fast",
    direct: "Direct",
    none: "None",
  },
  "histogram.orientation": { horizontal: "upright", vertical: "lying" },
  "histogram.scale": { linear: "linear", log: "logarithmic" },
  "histogram.font": { sans: "sans serif", serif: "serif" },
  "figure.unit": { px: "pixels", mm: "millimetres" },
  "figure.legend": { none: "none", bar: "colour bar", histogram: "histogram" },
  "figure.legend_place": { right: "right", left: "left" },
  "figure.scale_bar_place": CORNERS,
  "figure.axes_place": CORNERS,
  "figure.meshes": { together: "both in one", apart: "a file for each" },
  "figure.panels.setting": {
    none: "one picture",
    peel: "peel",
    regularisation: "regularisation",
    irregular: "irregular edges",
    separation: "separation",
    lighting: "lighting",
    slice: "slice",
    silhouette: "silhouette",
    line_opacity: "darkness of lines",
  },
};

/** The steps of the irregular edges. */
export const IRREGULAR_STEPS = [
  "Off",
  "Wires",
  "Wires, through",
  "Barbed",
  "Barbed, through",
  "Paper",
  "Paper, through",
];

/**
 * The words that a setting takes, for a combo box.
 *
 *     options: optionsOf("separation.mode")
 *
 * @template {keyof Choices} Path @param {Path} path
 * @returns {(known: { tables: Tables }) => { value: Choices[Path], name: string }[]}
 */
export function optionsOf(path) {
  return ({ tables }) => tables.choices[path].map((value) => ({ value, name: NAMES[path][value] }));
}

/** Where a setting's slider runs: between the schema's limits. @param {string} path @param {number} step */
export function rangeOf(path, step) {
  return (/** @type {{ tables: Tables }} */ { tables }) => {
    const [low, high] = tables.limits[path];
    return /** @type {const} */ ([low, high, step]);
  };
}
