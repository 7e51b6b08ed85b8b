import { NOT_FINITE } from "../colours/palettes.js";
import { tickText } from "../charts/ticks.js";

/**
 * What of a colour map's legend is no value on it: colours of what lies beyond a range that was set, and of what is not finite,
 * as far as there are such cells.
 *
 * @param {{ counts: ArrayLike<number>, map_position: ArrayLike<number>, not_finite: number }} data a histogram
 * @param {Pick<import("../state/status.js").Status["colour"], "range" | "beyond" | "above" | "below" | "missing">} colour
 * @param {boolean} highFirst whether the map's first colour is that of high values
 * @returns {{ colour: string, name: string }[]}
 */
export function keysOf({ counts, map_position, not_finite }, colour, highFirst) {
  const { range, beyond, above, below, missing } = colour;
  const some = (/** @type {(position: number) => boolean} */ out) =>
    Array.from(counts).some((n, bin) => n > 0 && out(map_position[bin]));
  const [low, high] = [some((position) => position < 0), some((position) => position > 1)];
  const [isAbove, isBelow] = highFirst ? [low, high] : [high, low];
  return [
    ...(beyond && range && isAbove ? [{ colour: above, name: `above ${tickText(range[1])}` }] : []),
    ...(beyond && range && isBelow ? [{ colour: below, name: `below ${tickText(range[0])}` }] : []),
    ...(not_finite > 0 ? [{ colour: missing ?? NOT_FINITE, name: "not finite" }] : []),
  ];
}
