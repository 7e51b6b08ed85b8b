/** @typedef {import("./pair_index.js").PairIndex} PairIndex @typedef {import("./pair_index.js").Place} Place */

/** Of so many things the pairs are outlined; of more, rows and columns tell enough. */
const FEW = 12;

/**
 * The places to be outlined for chosen things: one with itself, two with each other though they may not meet, of a few those
 * that do.
 *
 * @param {readonly number[]} things @param {PairIndex} index @returns {Place[]}
 */
export function outlinedPlaces(things, index) {
  if (things.length > FEW) return [];
  const places = things.flatMap((row) => things.map((column) => ({ row, column })));
  if (things.length < 2) return places;
  return places.filter(({ row, column }) =>
    things.length === 2 ? row !== column : index.pairAt({ row, column }) >= 0,
  );
}
