import { componentsOf } from "./components.js";
import { CATEGORIES, NOT_FINITE, paletteBytes } from "./palettes.js";

/**
 * The colour of a cell before light, as the surface's shader has it (`scene/layers/colour_shader.js`): for files.
 *
 * @typedef {[number, number, number]} Bytes  red, green, blue, 0 to 255, sRGB
 * @typedef {import("./palettes.js").Reading & { by: string, outside: string, inside: string }} Colouring  as a status has it
 */

/** A value's place on the map below which there is none. */
const NONE = -1;

/**
 * @param {Colouring} colour
 * @param {{ positions: Float32Array, highFirst: boolean } | null} values each cell's place on the map; null where sides are coloured
 * @returns {(cell: number, inside: number) => Bytes} inside: 0 on the boundary, 1 on what filters expose
 */
export function cellColours(colour, values) {
  const outside = bytesOf(colour.outside);
  const inside = bytesOf(colour.inside);
  if (!values || colour.by === "sides")
    return (_, share) =>
      /** @type {Bytes} */ (outside.map((part, k) => Math.round(part + share * (inside[k] - part))));
  const { positions, highFirst } = values;
  const category = colour.by in CATEGORIES;
  const palette = category ? paletteBytes(colour.by) : paletteBytes(colour.map ?? "parula", colour);
  const scale = category ? 1 : 255;
  const [first, last] = highFirst ? [colour.above, colour.below] : [colour.below, colour.above];
  const ends =
    !category && colour.beyond
      ? { first: bytesOf(first ?? NOT_FINITE), last: bytesOf(last ?? NOT_FINITE) }
      : null;
  const missing = bytesOf(colour.missing ?? NOT_FINITE);
  return (cell) => {
    const place = positions[cell];
    if (!Number.isFinite(place) || place < NONE) return missing;
    if (ends && place < 0) return ends.first;
    if (ends && place > 1) return ends.last;
    const entry = 4 * Math.trunc(Math.min(255, Math.max(0, place * scale + 0.5)));
    return [palette[entry], palette[entry + 1], palette[entry + 2]];
  };
}

/** @param {string} colour "#rrggbb" @returns {Bytes} */
function bytesOf(colour) {
  return /** @type {Bytes} */ (componentsOf(colour).map((part) => Math.round(255 * part)));
}
