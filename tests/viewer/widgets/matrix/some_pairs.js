import { random } from "../random.js";

/**
 * Different pairs of things, in no order, a few with themselves.
 *
 * @param {number} count @param {number} number of pairs, no more than there can be @param {number} seed
 */
export function somePairs(count, number, seed) {
  const next = random(seed);
  const found = new Set();
  while (found.size < number) {
    const [a, b] = [Math.floor(next() * count), Math.floor(next() * count)];
    found.add(Math.min(a, b) * count + Math.max(a, b));
  }
  const keys = [...found];
  const crossings = Int32Array.from(keys, () => Math.floor(next() * 3));
  return {
    count,
    one: Int32Array.from(keys, (key) => Math.floor(key / count)),
    other: Int32Array.from(keys, (key) => key % count),
    crossings,
    beside: Int32Array.from(crossings, (number) => (number ? Math.floor(next() * 2) : 1)),
  };
}

/** What every place of the matrix shows, row by row: 1 crosses, 2 side by side, 3 both. @param {ReturnType<typeof somePairs>} pairs */
export function dense({ count, one, other, crossings, beside }) {
  const out = new Uint8Array(count * count);
  one.forEach((a, k) => {
    const b = other[k];
    out[a * count + b] = out[b * count + a] = (crossings[k] ? 1 : 0) + (beside[k] ? 2 : 0);
  });
  return out;
}
