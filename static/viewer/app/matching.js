/**
 * Two cores that are told of each other's mesh.
 *
 * @typedef {import("./side.js").Side} Side
 * @typedef {import("../state/answers.js").Compared} Compared
 */

/**
 * Have each of two cores know what it is compared with: by what it has at hand, else by what the other hands over.
 *
 * @param {Side} first @param {Side} second @param {() => boolean} here whether it is still wanted
 * @returns {Promise<Compared | null>} what the first tells of the second; null if it is wanted no more
 */
export async function match(first, second, here) {
  const offered = [second, first].map(({ facts }) => facts.get("offered"));
  const [b, a] = offered;
  if (a !== null && b !== null) {
    const [told] = await Promise.all([
      first.client.call("compare_with_offered", [b, true]),
      second.client.call("compare_with_offered", [a, false]),
    ]);
    return here() ? told : null;
  }
  const sides = [first, second];
  const marks = await Promise.all(sides.map(({ client }) => client.call("fingerprint")));
  if (!here()) return null;
  const [ours, theirs] = await Promise.all([
    first.client.call("hand_over", [marks[1]]),
    second.client.call("hand_over", [marks[0]]),
  ]);
  if (!here()) return null;
  const [told] = await Promise.all([tell(first, theirs, true), tell(second, ours, false)]);
  return here() ? told : null;
}

/** @param {Side} side @param {import("../state/answers.js").HandedOver} handed of the other's mesh @param {boolean} second whether the other is the second */
function tell(side, { points, triangles, coordinates, ...told }, second) {
  const own = coordinates && bufferOf(coordinates);
  return side.client.call("compare_with", [told, bufferOf(points), bufferOf(triangles), own, second]);
}

/** A block of its own. @param {Float64Array | Int32Array} array @returns {ArrayBuffer} */
function bufferOf(array) {
  return /** @type {ArrayBuffer} */ (array.slice().buffer);
}
