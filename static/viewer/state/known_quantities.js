/**
 * A status without what a mesh has not got: quantities that it is coloured by and filtered by, and vectors that are drawn.
 *
 * @typedef {import("./status.js").Status} Status
 * @typedef {(quantity: string, components?: number) => boolean} Has  whether there is such an attribute, of so many components where
 *   that matters
 */

/** @param {Status} status @param {Has} has @returns {Status} itself where the mesh has everything */
export function asFarAsKnown(status, has) {
  const { colour, arrows, filters } = status;
  const { items } = filters.quality;
  const known = items.filter(({ quantity }) => !quantity.includes(":") || has(quantity));
  const parts = {
    ...(colour.by === "attribute" && !has(colour.attribute)
      ? { colour: { ...colour, by: /** @type {const} */ ("sides"), attribute: "" } }
      : {}),
    ...(arrows.attribute && !has(arrows.attribute, 3) ? { arrows: { ...arrows, attribute: "" } } : {}),
    ...(known.length < items.length
      ? { filters: { ...filters, quality: { ...filters.quality, items: known } } }
      : {}),
  };
  return Object.keys(parts).length ? { ...status, ...parts } : status;
}

/** A status under which colours are made for a range. @param {Status} status @param {readonly [number, number] | null} reach @returns {Status} */
export function withReach(status, reach) {
  return reach ? { ...status, colour: { ...status.colour, reach: [...reach] } } : status;
}
