import { niceTicks } from "../charts/ticks.js";

/**
 * Values along an axis that can all be read: both ends, and round values between them, none nearer to another than a gap.
 *
 * @param {number} low
 * @param {number} high
 * @param {number} length of the axis
 * @param {number} gap least distance of two labels, in the same unit
 * @returns {number[]} rising
 */
export function readableTicks(low, high, length, gap) {
  if (!(high > low)) return [low];
  const most = Math.max(1, Math.floor(length / gap));
  const place = (/** @type {number} */ value) => ((value - low) / (high - low)) * length;
  const ticks = [low];
  for (const value of niceTicks(low, high, most - 1))
    if (place(value) - place(ticks[ticks.length - 1]) >= gap && length - place(value) >= gap)
      ticks.push(value);
  return [...ticks, high];
}
