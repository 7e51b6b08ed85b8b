/**
 * Numbers as the page writes them: three decimals, an exponent where they would read 0.000 or run wide; counts
 * in groups of three.
 */

/** @param {number | null | undefined} value @param {number} [decimals] */
export function decimal(value, decimals = 3) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  const size = Math.abs(value);
  if (size !== 0 && (size < 0.5 * 10 ** -decimals || size >= 1e6)) return exponent(value);
  return value.toFixed(decimals).replace("-", "−");
}

/** A number as one can type it again. @param {number | null | undefined} value @param {number} [decimals] */
export function typed(value, decimals = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "";
  return decimal(value, decimals).replaceAll("−", "-");
}

/** @param {number} value */
function exponent(value) {
  return value.toExponential(2).replace("e+", "e").replaceAll("-", "−");
}

/** @param {number | null | undefined} value */
export function count(value) {
  return value === null || value === undefined ? "–" : value.toLocaleString("en-GB");
}

/** "1 cell", "2 cells". @param {number} number @param {string} one @param {string} [many] */
export function counted(number, one, many = `${one}s`) {
  return `${count(number)} ${number === 1 ? one : many}`;
}

/** A typed number, a comma taken for a point and − for a minus; null when it is none. @param {string} text @returns {number | null} */
export function parsed(text) {
  const clean = text.trim().replace(",", ".").replaceAll("−", "-");
  if (clean === "") return null;
  const value = Number(clean);
  return Number.isFinite(value) ? value : null;
}

/** Where a value is between two ends, 0 to 1, though their distance may pass what a number holds. @param {number} value @param {number} low @param {number} high */
export function shareOf(value, low, high) {
  return clamp((value / 2 - low / 2) / (high / 2 - low / 2), 0, 1);
}

/** The value at a share between two ends. @param {number} share @param {number} low @param {number} high */
export function between(share, low, high) {
  return low * (1 - share) + high * share;
}

/** @param {number} value @param {number} low @param {number} high */
export function clamp(value, low, high) {
  return Math.min(high, Math.max(low, value));
}
