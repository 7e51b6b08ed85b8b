/** Points from which on some are left out. */
const MANY = 4096;

/**
 * The points that stand out of many: those that lie farthest in some hundred directions spread evenly.
 *
 * @param {ArrayLike<number>} positions 3 coordinates for each
 * @returns {ArrayLike<number>}
 */
export function standing(positions) {
  if (positions.length <= 3 * MANY) return positions;
  const farthest = DIRECTIONS.map(() => ({ at: 0, reach: -Infinity }));
  const step = 3 * Math.max(1, Math.floor(positions.length / 3 / 65_536));
  for (let k = 0; k < positions.length; k += step) {
    const [px, py, pz] = [positions[k], positions[k + 1], positions[k + 2]];
    for (let d = 0; d < DIRECTIONS.length; d++) {
      const [x, y, z] = DIRECTIONS[d];
      const reach = x * px + y * py + z * pz;
      if (reach > farthest[d].reach) farthest[d] = { at: k, reach };
    }
  }
  return farthest.flatMap(({ at }) => [positions[at], positions[at + 1], positions[at + 2]]);
}

/** A spiral over the sphere (Fibonacci's lattice). */
const DIRECTIONS = Array.from({ length: 200 }, (_, k) => {
  const z = 1 - (2 * k + 1) / 200;
  const angle = k * Math.PI * (3 - Math.sqrt(5));
  const radius = Math.sqrt(1 - z * z);
  return [radius * Math.cos(angle), radius * Math.sin(angle), z];
});
