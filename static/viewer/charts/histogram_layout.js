import { between, clamp, shareOf } from "../state/numbers.js";
import { corners } from "./steps.js";
import { niceTicks } from "./ticks.js";

/**
 * Where the parts of a histogram stand: pure geometry, for the page and for export alike.
 *
 * @typedef {object} HistogramData
 * @property {ArrayLike<number>} edges bins + 1 values, rising
 * @property {ArrayLike<number>} counts
 * @property {ArrayLike<number>} map_position of each bin on the colour map
 * @property {number} low
 * @property {number} high
 * @property {{ edges: ArrayLike<number>, counts: number[] } | null} [beside] those of a second mesh
 *
 * @typedef {{ width: number, height: number, orientation: "horizontal" | "vertical", scale: "linear" | "log", unit?: string }} Frame  unit:
 *   of the values, if they have one that is named
 * @typedef {{ x: number, y: number, width: number, height: number }} Box
 *
 * @typedef {object} Layout
 * @property {Box} plot
 * @property {boolean} upright bars stand on the value axis; else they lie along it
 * @property {number} low
 * @property {number} high
 * @property {string} unit told at the axis; may be empty
 * @property {number} highest the largest count, of both meshes where there are two
 * @property {{ box: Box, bin: number }[]} bars
 * @property {{ value: number, at: number }[]} ticks
 * @property {[value: number, share: number][]} steps corners of a second mesh's counts; none without one
 */

/** In pixels; at the top the largest count stands, and the acceptable range below it. */
const MARGIN = { top: 24, right: 8, bottom: 20, left: 8 };
const LYING_LEFT = 44;

/** Of the line that tells the unit below upright bars. */
const UNIT_LINE = 14;

/** @param {HistogramData} data @param {Frame} frame @returns {Layout} */
export function layOut(data, { width, height, orientation, scale, unit = "" }) {
  const upright = orientation === "horizontal";
  const left = upright ? MARGIN.left : LYING_LEFT;
  const bottom = upright ? MARGIN.bottom + (unit ? UNIT_LINE : 0) : MARGIN.right;
  const plot = {
    x: left,
    y: MARGIN.top,
    width: Math.max(1, width - left - MARGIN.right),
    height: Math.max(1, height - MARGIN.top - bottom),
  };
  const low = Number(data.edges[0]);
  const high = Number(data.edges[data.edges.length - 1]);
  const counts = Array.from(data.counts, Number);
  const highest = largestOf(counts, data.beside);
  const share =
    scale === "log"
      ? (/** @type {number} */ n) => Math.log1p(n) / Math.log1p(highest)
      : (/** @type {number} */ n) => n / highest;
  const layout = { plot, upright, low, high, unit, highest };
  const bars = counts.flatMap((n, bin) => {
    if (!n) return [];
    const from = along(layout, Number(data.edges[bin]));
    const to = along(layout, Number(data.edges[bin + 1]));
    return [
      {
        bin,
        box: barBox(layout, Math.min(from, to), Math.abs(to - from), Math.max(share(n), 1 / span(layout))),
      },
    ];
  });
  const ticks = niceTicks(low, high, upright ? 5 : 7).map((value) => ({ value, at: along(layout, value) }));
  const steps = data.beside && highest ? corners(data.beside, layout, share) : [];
  return { ...layout, bars, ticks, steps };
}

/** The largest count, in whole cells: those of a second mesh may be scaled. @param {readonly number[]} counts @param {HistogramData["beside"]} beside */
export function largestOf(counts, beside) {
  return Math.max(0, ...counts, ...(beside?.counts ?? []).map(Math.round));
}

/** Length of the count axis in pixels. @param {{ plot: Box, upright: boolean }} layout */
function span({ plot, upright }) {
  return upright ? plot.height : plot.width;
}

/** @param {{ plot: Box, upright: boolean }} layout @param {number} from @param {number} size @param {number} share @returns {Box} */
function barBox({ plot, upright }, from, size, share) {
  if (upright)
    return { x: from, y: plot.y + plot.height * (1 - share), width: size, height: plot.height * share };
  return { x: plot.x, y: from, width: plot.width * share, height: size };
}

/** Pixel of a value along the value axis. @param {{ plot: Box, upright: boolean, low: number, high: number }} layout @param {number} value */
export function along({ plot, upright, low, high }, value) {
  const share = high > low ? shareOf(value, low, high) : 0.5;
  return upright ? plot.x + share * plot.width : plot.y + (1 - share) * plot.height;
}

/** Value at a pixel: the inverse of `along`. @param {Layout} layout @param {number} pixel */
export function valueUnder({ plot, upright, low, high }, pixel) {
  const share = upright ? (pixel - plot.x) / plot.width : 1 - (pixel - plot.y) / plot.height;
  return between(clamp(share, 0, 1), low, high);
}
