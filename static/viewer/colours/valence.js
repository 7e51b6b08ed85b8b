/**
 * How an irregular edge looks by its valence: its wire, the barbs to its neighbours, and the paper flaps from rim to edge.
 * Hue tells 3 (red), 5 (green), 6 and more (blue), 2 and fewer (purple); the legend gives the numbers.
 */
export const VALENCE_STYLES = [
  { label: "2 and fewer", wire: "#9a35b0", barb: "#b96cca", rim: "#d08be0", inner: "#6d1f80" },
  { label: "3", wire: "#cc3d3d", barb: "#e07a7a", rim: "#ff7a7a", inner: "#992e2e" },
  { label: "4", wire: "#b7791f", barb: "#d2a65e", rim: "#efc37a", inner: "#7a5013" },
  { label: "5", wire: "#12a012", barb: "#58c458", rim: "#63e063", inner: "#1d701d" },
  { label: "6 and more", wire: "#3333ff", barb: "#7a7aff", rim: "#6b6bff", inner: "#1a1a80" },
];

/**
 * Row of `VALENCE_STYLES` for a valence.
 *
 * @param {number} valence
 * @returns {number}
 */
export function valenceStyle(valence) {
  return Math.min(6, Math.max(2, valence)) - 2;
}
