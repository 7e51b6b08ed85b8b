/** Numbers from 0 to 1 that come again the same on every run (Park and Miller). @param {number} seed */
export function random(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}
