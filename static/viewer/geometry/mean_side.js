/**
 * Mean length of the sides of a surface's faces, from a sample of some two thousand.
 *
 * @param {Float32Array} positions
 * @param {Uint32Array | null} quads
 * @param {number} faces
 * @returns {number}
 */
export function meanSide(positions, quads, faces) {
  const stride = Math.max(1, Math.floor(faces / 2048));
  let sum = 0;
  let sides = 0;
  for (let f = 0; f < faces; f += stride) {
    for (let k = 0; k < 4; k++) {
      const a = 3 * (quads ? quads[4 * f + k] : 4 * f + k);
      const b = 3 * (quads ? quads[4 * f + ((k + 1) & 3)] : 4 * f + ((k + 1) & 3));
      const side = Math.hypot(
        positions[a] - positions[b],
        positions[a + 1] - positions[b + 1],
        positions[a + 2] - positions[b + 2],
      );
      if (side > 0) {
        sum += side;
        sides++;
      }
    }
  }
  return sides > 0 ? sum / sides : 1;
}
