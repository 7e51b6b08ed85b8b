/**
 * The quality filter (SPEC F3) as the panel shows it: which end of the values is kept, and its bounds in native values.
 *
 * @typedef {import("./status.js").Status["filters"]["quality"]["items"][number]} Band
 * @typedef {{ worstValue: number, bestValue: number, outer?: readonly [number, number] | null }} Scale  ends of the slider, in native
 *   values; the percentiles between which most values lie
 * @typedef {"worst" | "best" | "band" | "outside"} Keep
 */

/** @type {Record<Keep, string>} */
export const KEEP_NAMES = {
  worst: "show the worst",
  best: "show the best",
  band: "show a band",
  outside: "hide a band",
};

/** The same for an attribute, which has no good end. @type {Record<Keep, string>} */
export const KEEP_NAMES_OF_ATTRIBUTES = {
  worst: "show the high",
  best: "show the low",
  band: "show a band",
  outside: "hide a band",
};

/** Whether a high value is a good one. @param {Scale} scale */
const highIsBest = (scale) => scale.bestValue >= scale.worstValue;

/** @param {Band | undefined} band @param {Scale} scale @returns {Keep} */
export function keepOf(band, scale) {
  if (!band) return "worst";
  if (band.keep === "outside") return "outside";
  if (band.minimum !== null && band.maximum !== null) return "band";
  if (band.minimum === null && band.maximum === null) return "worst";
  return (band.maximum !== null) === highIsBest(scale) ? "worst" : "best";
}

/**
 * The band that keeps one end, its threshold given as a share of the way: 0 hides nothing, 1 hides all but the far end.
 *
 * @param {string} quantity @param {"worst" | "best"} keep @param {number} share @param {Scale} scale @returns {Band | null}
 */
export function oneSided(quantity, keep, share, scale) {
  if (share <= 0) return null;
  const [start, end] =
    keep === "worst" ? [scale.bestValue, scale.worstValue] : [scale.worstValue, scale.bestValue];
  return boundedBy(quantity, keep, start + share * (end - start), scale);
}

/** The band with a typed threshold. @param {string} quantity @param {"worst" | "best"} keep @param {number} value @param {Scale} scale @returns {Band} */
export function boundedBy(quantity, keep, value, scale) {
  const isMaximum = (keep === "worst") === highIsBest(scale);
  return { quantity, keep: "inside", minimum: isMaximum ? null : value, maximum: isMaximum ? value : null };
}

/** The native threshold of a one-sided band, or null. @param {Band | undefined} band */
export function thresholdOf(band) {
  return band ? (band.maximum ?? band.minimum) : null;
}

/** Where on the slider the band stands. @param {Band | undefined} band @param {"worst" | "best"} keep @param {Scale} scale */
export function shareOf(band, keep, scale) {
  const value = thresholdOf(band);
  if (value === null) return 0;
  const [start, end] =
    keep === "worst" ? [scale.bestValue, scale.worstValue] : [scale.worstValue, scale.bestValue];
  return end === start ? 0 : Math.min(1, Math.max(0, (value - start) / (end - start)));
}

/** The band when another way of keeping is chosen. @param {string} quantity @param {Keep} keep @param {Band | undefined} band @param {Scale} scale @returns {Band | null} */
export function changedKeep(quantity, keep, band, scale) {
  const [low, high] = scale.outer ?? [
    Math.min(scale.worstValue, scale.bestValue),
    Math.max(scale.worstValue, scale.bestValue),
  ];
  if (keep === "band" || keep === "outside") {
    return {
      quantity,
      keep: keep === "band" ? "inside" : "outside",
      minimum: band?.minimum ?? low,
      maximum: band?.maximum ?? high,
    };
  }
  const value = thresholdOf(band) ?? (keep === "worst" ? scale.bestValue : scale.worstValue);
  return boundedBy(quantity, keep, value, scale);
}
