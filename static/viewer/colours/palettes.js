import { componentsOf } from "./components.js";
import { CHOSEN, CROSSING, REST } from "./structure.js";

/**
 * Colour maps as rows of [position, colour]; the first colour is that of the best cell. Between knots the colour runs
 * straight. Parula and viridis are sampled from their published definitions, jet and red-blue are defined by knots. Diverging
 * is for changes: its middle is no change.
 *
 * @type {Record<string, [number, string][]>}
 */
const KNOTS = {
  parula: [
    [0, "#352a87"],
    [4 / 63, "#3243ba"],
    [6 / 63, "#2053d4"],
    [8 / 63, "#0363e1"],
    [12 / 63, "#0d75dc"],
    [16 / 63, "#1485d4"],
    [20 / 63, "#0998d1"],
    [24 / 63, "#06a7c6"],
    [28 / 63, "#16b1b4"],
    [32 / 63, "#38b99e"],
    [36 / 63, "#65be86"],
    [40 / 63, "#92bf73"],
    [46 / 63, "#c8bc5d"],
    [50 / 63, "#e9b94e"],
    [53 / 63, "#fdbe3d"],
    [56 / 63, "#fcce2e"],
    [60 / 63, "#f5e41d"],
    [1, "#f9fb0e"],
  ],
  jet: [
    [0, "#00007f"],
    [1 / 72, "#00007f"],
    [10 / 72, "#0000ff"],
    [28 / 72, "#00ffff"],
    [46 / 72, "#ffff00"],
    [64 / 72, "#ff0000"],
    [1, "#8d0000"],
  ],
  red_blue: [
    [0, "#0000ff"],
    [0.5, "#ffffff"],
    [1, "#ff0000"],
  ],
  diverging: [
    [0, "#1f5fa8"],
    [0.25, "#84b3dc"],
    [0.5, "#f4f2ee"],
    [0.75, "#ee9a7b"],
    [1, "#b01f2e"],
  ],
  viridis: [
    "#440154", "#481a6c", "#472f7d", "#414487", "#39568c", "#31688e", "#2a788e", "#23888e",
    "#1f988b", "#22a884", "#35b779", "#54c568", "#7ad151", "#a5db36", "#d2e21b", "#fde725",
  ].map((colour, k) => [k / 15, colour]), // prettier-ignore
};

/**
 * Colours of categories, by their numbers. Kinds: hexahedron, wedge, pyramid, tetrahedron, other, in the order of the core's
 * `SHAPES`. Parts: of the schemes of Paul Tol (SRON/EPS/TN/09-002, 2021) and of Okabe and Ito (2008) eight that are farthest apart
 * to usual eyes and to those that lack a kind of cone; past the last it begins again. Groups: twelve, searched for on a grid of sRGB
 * so that the least distance in CIELAB is as large as can be to the same eyes (first six 24, all 17), light enough for dark lines to
 * be read on them (lightness from 58), and away from the grey of what is in no group. Blocks: twelve light ones, searched for in the
 * same way, each 30 in CIELAB from every other, since all of them may lie side by side.
 *
 * @type {Record<string, readonly string[]>}
 */
export const CATEGORIES = {
  kind: ["#f2efe8", "#e5a04c", "#5aa9a0", "#a06ab4", "#c8372d"],
  group: [
    "#6688ee", "#ffcc66", "#aaeedd", "#44aa77", "#cc7733", "#bb77bb", "#00ccff", "#eeddaa", "#00eeff", "#88bb66", "#ccaacc", "#eeaaaa",
  ], // prettier-ignore
  block: [
    "#cceebb", "#ff99cc", "#33aaee", "#ee8877", "#22eeff", "#ddddff", "#99aa55", "#55bb88", "#88bbbb", "#ffdd88", "#aa99dd", "#ddbbaa",
  ], // prettier-ignore
  chosen: [...CHOSEN, CROSSING, REST],
  part: ["#77aadd", "#ee8866", "#bbcc33", "#ffaabb", "#4477aa", "#eedd88", "#d55e00", "#cc6677"],
};

/** @param {string} by what is coloured by @param {number} category */
export function categoryColour(by, category) {
  const colours = CATEGORIES[by];
  return colours[category % colours.length];
}

/** Colour of a cell whose value is not a number, or not finite. */
export const NOT_FINITE = "#8c8c8c";

export const PALETTES = Object.freeze(Object.keys(KNOTS));

/**
 * Colour of a map at a position from 0 (best) to 1.
 *
 * @param {string} map name, one of `PALETTES`
 * @param {number} position
 * @returns {[number, number, number]} components, 0 to 1
 */
export function paletteColour(map, position) {
  const knots = KNOTS[map] ?? KNOTS.parula;
  const t = Math.min(1, Math.max(0, position));
  let k = 1;
  while (k < knots.length - 1 && knots[k][0] < t) k++;
  const [t0, hex0] = knots[k - 1];
  const [t1, hex1] = knots[k];
  const f = (t - t0) / (t1 - t0);
  const a = componentsOf(hex0);
  const b = componentsOf(hex1);
  return [a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])];
}

/**
 * Where on the map a position is read: turned round, and on the middle of a step, if so wished.
 *
 * @param {number} position 0 to 1 @param {Reading} reading
 */
function placed(position, { reversed = false, steps = 0 }) {
  const stepped = steps > 1 ? Math.min(steps - 1, Math.floor(position * steps)) / (steps - 1) : position;
  return reversed ? 1 - stepped : stepped;
}

/**
 * How a map is read: as a status has it.
 *
 * @typedef {{ map?: string, reversed?: boolean, steps?: number, missing?: string, beyond?: boolean, above?: string, below?: string }} Reading
 */

/**
 * Colours of a map for style sheets and SVG.
 *
 * @param {Reading} reading
 * @param {boolean} [highFirst] whether the map's first colour is that of high values
 * @returns {(position: number) => string}
 */
export function mapColours(reading, highFirst = false) {
  const [first, last] = highFirst ? [reading.above, reading.below] : [reading.below, reading.above];
  return (position) => {
    if (!Number.isFinite(position)) return reading.missing ?? NOT_FINITE;
    const end = position < 0 ? first : position > 1 ? last : null;
    if (reading.beyond && end) return end;
    const place = placed(Math.min(1, Math.max(0, position)), reading);
    const bytes = paletteColour(reading.map ?? "parula", place).map((part) => Math.round(part * 255));
    return `#${bytes.map((byte) => byte.toString(16).padStart(2, "0")).join("")}`;
  };
}

/**
 * The 256 entries of a map as bytes, four to an entry.
 *
 * @param {string} map
 * @param {Reading} [reading]
 * @returns {Uint8Array}
 */
export function paletteBytes(map, reading = {}) {
  const bytes = new Uint8Array(256 * 4);
  for (let k = 0; k < 256; k++) {
    const colour =
      map in CATEGORIES ? componentsOf(categoryColour(map, k)) : paletteColour(map, placed(k / 255, reading));
    for (let c = 0; c < 3; c++) bytes[4 * k + c] = Math.round(255 * colour[c]);
    bytes[4 * k + 3] = 255;
  }
  return bytes;
}
