/**
 * Whether a flat face, of four vertices that follow each other, is a triangle: its last two coincide.
 *
 * @param {Float32Array} positions
 * @param {number} base where its first number stands
 * @returns {boolean}
 */
export function isTriangle(positions, base) {
  return (
    positions[base + 6] === positions[base + 9] &&
    positions[base + 7] === positions[base + 10] &&
    positions[base + 8] === positions[base + 11]
  );
}
