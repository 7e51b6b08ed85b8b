/** Each number less the one before: small where numbers follow each other. @param {Uint32Array} numbers @returns {Int32Array} */
export function steps(numbers) {
  return Int32Array.from(numbers, (number, k) => number - (k ? numbers[k - 1] : 0));
}

/** The numbers of such steps. @param {Int32Array} steps @returns {Uint32Array} */
export function summed(steps) {
  let sum = 0;
  return Uint32Array.from(steps, (step) => (sum += step));
}
