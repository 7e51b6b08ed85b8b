/**
 * The counts of a second mesh over the bars of the first, as an outline.
 *
 * @typedef {{ edges: ArrayLike<number>, counts: ArrayLike<number> }} Counted  counts of cells in bins, whose edges rise
 */

/**
 * The counts of another mesh as they would be if it had as many cells.
 *
 * @param {Counted} data of the first @param {Counted} other
 * @returns {{ edges: ArrayLike<number>, counts: number[], scaled: boolean }}
 */
export function beside(data, other) {
  const total = (/** @type {Counted} */ { counts }) =>
    Array.from(counts, Number).reduce((sum, count) => sum + count, 0);
  const [ours, theirs] = [total(data), total(other)];
  const factor = theirs && ours !== theirs ? ours / theirs : 1;
  return {
    edges: other.edges,
    counts: Array.from(other.counts, (count) => Number(count) * factor),
    scaled: factor !== 1,
  };
}

/**
 * The corners of the outline, along the value axis and away from it.
 *
 * @param {{ edges: ArrayLike<number>, counts: readonly number[] }} steps
 * @param {{ low: number, high: number }} axis values at its ends
 * @param {(count: number) => number} share of the count axis
 * @returns {[value: number, share: number][]}
 */
export function corners({ edges, counts }, { low, high }, share) {
  const within = (/** @type {number} */ value) => Math.min(high, Math.max(low, value));
  /** @type {[number, number][]} */
  const found = [[within(Number(edges[0])), 0]];
  counts.forEach((count, bin) => {
    const height = Math.min(1, share(count));
    found.push([within(Number(edges[bin])), height], [within(Number(edges[bin + 1])), height]);
  });
  return [...found, [within(Number(edges[counts.length])), 0]];
}
