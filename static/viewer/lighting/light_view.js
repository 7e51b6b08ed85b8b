/**
 * The orthographic view from one direction that just holds a box, as three rows that take a point (x, y, z, 1) to the square
 * from -1 to 1 and to a depth from -1 (nearest to the light) to 1.
 *
 * @param {ArrayLike<number>} direction unit vector towards the light
 * @param {ArrayLike<number>} box min x, y, z, max x, y, z
 * @param {number} margin share of the square left free at each side
 * @returns {{ x: number[], y: number[], z: number[] }}
 */
export function lightView(direction, box, margin) {
  const [dx, dy, dz] = [direction[0], direction[1], direction[2]];
  // Orthonormal basis without a singular direction (Duff et al. 2017).
  const sign = dz >= 0 ? 1 : -1;
  const a = -1 / (sign + dz);
  const b = dx * dy * a;
  const right = [1 + sign * dx * dx * a, sign * b, -sign * dx];
  const up = [b, sign + dy * dy * a, -dy];
  return {
    x: row(right, box, 1 - 2 * margin),
    y: row(up, box, 1 - 2 * margin),
    z: row([-dx, -dy, -dz], box, 0.98),
  };
}

/**
 * @param {number[]} axis
 * @param {ArrayLike<number>} box
 * @param {number} reach the box ends at plus and minus this
 */
function row(axis, box, reach) {
  let middle = 0;
  let half = 1e-6;
  for (let k = 0; k < 3; k++) {
    middle += (axis[k] * (box[k] + box[k + 3])) / 2;
    half += (Math.abs(axis[k]) * (box[k + 3] - box[k])) / 2;
  }
  const scale = reach / half;
  return [axis[0] * scale, axis[1] * scale, axis[2] * scale, -middle * scale];
}
