/**
 * Bytes as people read them: "1.4 MB".
 *
 * @param {number | null | undefined} size
 */
export function fileSize(size) {
  if (size === null || size === undefined) return "size not known";
  for (const [unit, limit] of UNITS) {
    const value = size / (limit / 1e3);
    if (size < limit) return `${value.toFixed(unit === "B" || value >= 100 ? 0 : 1)} ${unit}`;
  }
  return `${(size / 1e9).toFixed(1)} GB`;
}

/** @type {readonly (readonly [string, number])[]} */
const UNITS = [
  ["B", 1e3],
  ["kB", 1e6],
  ["MB", 1e9],
];
