/**
 * Numbers as the page writes them: three decimals, more where less than three digits would tell something, an exponent where
 * they are tiny or run wide; all in groups of three.
 */

/** @param {number | null | undefined} value @param {number} [decimals] */
export function decimal(value, decimals = 3) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : "−∞";
  return grouped(digitsOf(value, decimals)).replaceAll("-", "−");
}

/** At least three digits that tell something. @param {number} value @param {number} decimals */
function digitsOf(value, decimals) {
  const size = Math.abs(value);
  const tiny = decimals < 3 ? 0.5 * 10 ** -decimals : TINY;
  if (size !== 0 && (size < tiny || size >= WIDE)) return value.toExponential(2).replace("e+", "e");
  if (decimals < 3 || size === 0 || size >= 0.1) return value.toFixed(decimals);
  return value.toFixed(3 - Math.floor(Math.log10(size)) - 1);
}

/** "12345.678" as "12,345.678". @param {string} digits */
function grouped(digits) {
  const [whole, ...rest] = digits.split(".");
  return [whole.replace(/\B(?=(\d{3})+$)/g, ","), ...rest].join(".");
}

/** Sizes below and from which a number has an exponent. */
const TINY = 1e-3;
const WIDE = 1e6;

/** A number as one can type it again. @param {number | null | undefined} value @param {number} [decimals] */
export function typed(value, decimals = 3) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "";
  return digitsOf(value, decimals);
}

/** @param {number | null | undefined} value */
export function count(value) {
  return value === null || value === undefined ? "–" : value.toLocaleString("en-GB");
}

/** "1 cell", "2 cells". @param {number} number @param {string} one @param {string} [many] */
export function counted(number, one, many = `${one}s`) {
  return `${count(number)} ${number === 1 ? one : many}`;
}

/** Zero in the scripts that have digits of their own; nine others follow each. */
const ZEROS = [
  0x660, 0x6f0, 0x7c0, 0x966, 0x9e6, 0xa66, 0xae6, 0xb66, 0xbe6, 0xc66, 0xce6, 0xd66, 0xe50, 0xed0, 0xf20,
  0x1040, 0x17e0, 0x1810, 0xff10,
];

/** @param {string} digit */
function latinDigit(digit) {
  const code = digit.charCodeAt(0);
  const zero = ZEROS.find((start) => code >= start && code < start + 10);
  return zero === undefined ? digit : String(code - zero);
}

/**
 * A typed number, as it is written anywhere: digits of any script, a point or a comma before the decimals, blanks,
 * apostrophes, points or commas between groups of three, any minus. A single comma or point stands before decimals:
 * "1,234" is a little more than 1.
 *
 * @param {string} text
 * @returns {number | null} null when it is none
 */
export function parsed(text) {
  const plain = text
    .trim()
    .replace(/\p{Nd}/gu, latinDigit)
    .replace(/[−–‒﹣－]/g, "-")
    .replace(/[，٫]/g, ",")
    .replace(/．/g, ".")
    .replace(/(?<=\d)[\s'’٬_](?=\d{3}(?!\d))/g, "");
  const marks = plain.match(/[.,]/g) ?? [];
  const last = marks.at(-1) ?? "";
  const grouping = new Set(marks).size === 2 ? (last === "." ? "," : ".") : marks.length > 1 ? last : "";
  const whole = plain.split(last && last !== grouping ? last : "e")[0];
  if (grouping && !whole.replace(/^[-+]/, "").split(grouping).every(isGroup)) return null;
  const clean = (grouping ? plain.replaceAll(grouping, "") : plain).replace(",", ".");
  return /^[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?$/i.test(clean) && Number.isFinite(Number(clean))
    ? Number(clean)
    : null;
}

/** Whether a part between marks can be one of groups of three: the first may be shorter. @param {string} part @param {number} index */
function isGroup(part, index) {
  return index ? /^\d{3}$/.test(part) : /^\d{1,3}$/.test(part);
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
