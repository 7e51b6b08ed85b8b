import { count, counted } from "../../state/numbers.js";

/**
 * @typedef {object} Meeting  of two things, or of one with itself
 * @property {string} one @property {string} other
 * @property {number} crossings
 * @property {number} beside
 *
 * @typedef {readonly [one: string, many: string]} Kind  what the things are called
 */

/** "once", "24 times". @param {number} number */
const often = (number) => (number === 1 ? "once" : `${count(number)} times`);

/** "Sheets 3 and 17: cross 24 times, 12 faces side by side". @param {Meeting} meeting @param {Kind} kind */
export function meetingInWords({ one, other, crossings, beside }, kind) {
  const self = one === other;
  const [thing, things] = kind.map((word) => word[0].toUpperCase() + word.slice(1));
  const names = self ? `${thing} ${one}` : `${things} ${one} and ${other}`;
  const parts = [
    crossings > 0 ? `${self ? "crosses itself" : "cross"} ${often(crossings)}` : "",
    beside > 0 ? `${counted(beside, "face")} side by side` : "",
  ].filter(Boolean);
  if (parts.length) return `${names}: ${parts.join(", ")}`;
  return self ? `${names}: does not cross itself` : `${names}: do not meet`;
}
