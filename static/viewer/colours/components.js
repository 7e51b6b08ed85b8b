/**
 * Components of a colour written "#rrggbb", each 0 to 1, as the screen takes them: no colour management in between.
 *
 * @param {string} hex
 * @returns {[number, number, number]}
 */
export function componentsOf(hex) {
  const value = Number.parseInt(hex.slice(1), 16);
  return [((value >> 16) & 255) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}
