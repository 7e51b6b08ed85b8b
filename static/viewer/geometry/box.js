/**
 * Boxes along the axes.
 *
 * @typedef {{ low: [number, number, number], high: [number, number, number] }} Box
 */

/**
 * The box of some points; null for none.
 *
 * @param {ArrayLike<number>} positions 3 per point
 * @returns {Box | null}
 */
export function boxOf(positions) {
  if (positions.length < 3) return null;
  let [x0, y0, z0] = [Infinity, Infinity, Infinity];
  let [x1, y1, z1] = [-Infinity, -Infinity, -Infinity];
  for (let k = 0; k + 2 < positions.length; k += 3) {
    const [x, y, z] = [positions[k], positions[k + 1], positions[k + 2]];
    if (x < x0) x0 = x;
    if (x > x1) x1 = x;
    if (y < y0) y0 = y;
    if (y > y1) y1 = y;
    if (z < z0) z0 = z;
    if (z > z1) z1 = z;
  }
  return { low: [x0, y0, z0], high: [x1, y1, z1] };
}

/** Its eight corners, 3 coordinates for each. @param {Box} box @returns {number[]} */
export function cornersOf({ low, high }) {
  return [0, 1, 2, 3, 4, 5, 6, 7].flatMap((corner) =>
    [0, 1, 2].map((axis) => ((corner >> axis) & 1 ? high : low)[axis]),
  );
}

/** The least box that holds all of some. @param {readonly (Box | null)[]} boxes @returns {Box | null} */
export function around(boxes) {
  const some = boxes.filter((box) => box !== null);
  if (!some.length) return null;
  const least = (/** @type {number} */ axis) => Math.min(...some.map(({ low }) => low[axis]));
  const most = (/** @type {number} */ axis) => Math.max(...some.map(({ high }) => high[axis]));
  return { low: [least(0), least(1), least(2)], high: [most(0), most(1), most(2)] };
}
