/** Number of directions from which light falls on the model. */
export const DIRECTIONS = 1024;

// The two-dimensional relative of the golden ratio: the real root of x^3 = x + 1 (Roberts 2018, "The unreasonable
// effectiveness of quasirandom sequences"). Steps of 1/g and 1/g^2 fill the square evenly at every length.
const G = 1.32471795724474602596;

/** Where the heights begin: of forty places, the one whose shortest prefixes are the most even. */
const BEGIN = 0.65;

/**
 * Directions spread evenly over the sphere, the same on every run, such that the first n are evenly spread too for every n:
 * a quasirandom sequence on the square, carried over by Archimedes' map, which keeps areas.
 *
 * @param {number} [count]
 * @returns {Float64Array} (3 count) unit vectors
 */
export function directions(count = DIRECTIONS) {
  const out = new Float64Array(3 * count);
  for (let k = 0; k < count; k++) {
    const z = 1 - 2 * ((BEGIN + k / G) % 1);
    const angle = 2 * Math.PI * ((0.5 + k / (G * G)) % 1);
    const r = Math.sqrt(1 - z * z);
    out[3 * k] = r * Math.cos(angle);
    out[3 * k + 1] = z;
    out[3 * k + 2] = r * Math.sin(angle);
  }
  return out;
}
