/**
 * How an irregular edge looks by its valence: its wire, the barbs to its neighbours, the paper flaps from rim to edge, and how broad
 * its wire is beside the others.
 *
 * @typedef {{ label: string, wire: string, barb: string, rim: string, inner: string, width: number }} ValenceStyle
 */

/**
 * Standard: hue tells 3 (red), 5 (green), 6 and more (blue), 2 and fewer (purple). For colour-blind eyes: colours of Okabe and Ito
 * (2008) that deuteranopes and protanopes tell apart, and as a second sign the wire is the broader the more cells are around it.
 *
 * @type {Readonly<Record<"standard" | "colour_blind", readonly ValenceStyle[]>>}
 */
export const VALENCE_STYLES = {
  standard: [
    { label: "2 and fewer", wire: "#9a35b0", barb: "#b96cca", rim: "#d08be0", inner: "#6d1f80", width: 1 },
    { label: "3", wire: "#cc3d3d", barb: "#e07a7a", rim: "#ff7a7a", inner: "#992e2e", width: 1 },
    { label: "4", wire: "#b7791f", barb: "#d2a65e", rim: "#efc37a", inner: "#7a5013", width: 1 },
    { label: "5", wire: "#12a012", barb: "#58c458", rim: "#63e063", inner: "#1d701d", width: 1 },
    { label: "6 and more", wire: "#3333ff", barb: "#7a7aff", rim: "#6b6bff", inner: "#1a1a80", width: 1 },
  ],
  colour_blind: [
    { label: "2 and fewer", wire: "#cc79a7", barb: "#dba4c3", rim: "#e8c3d8", inner: "#8f4f73", width: 0.6 },
    { label: "3", wire: "#d55e00", barb: "#e69a5c", rim: "#f2bd91", inner: "#934100", width: 1 },
    { label: "4", wire: "#e69f00", barb: "#efc261", rim: "#f6dba0", inner: "#9c6c00", width: 1.3 },
    { label: "5", wire: "#0072b2", barb: "#5aa5d1", rim: "#9accea", inner: "#004d78", width: 1.8 },
    { label: "6 and more", wire: "#000000", barb: "#555555", rim: "#999999", inner: "#000000", width: 2.6 },
  ],
};

/**
 * Row of `VALENCE_STYLES` for a valence.
 *
 * @param {number} valence
 * @returns {number}
 */
export function valenceStyle(valence) {
  return Math.min(6, Math.max(2, valence)) - 2;
}
