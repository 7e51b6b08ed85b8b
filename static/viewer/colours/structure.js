import { VALENCE_STYLES } from "./valence.js";

/** Colours of what was chosen, in the order in which it was; after the last it begins again. Teal and amber stand first. */
export const CHOSEN = [
  "#17a398", "#f2a93b", "#8f7ee0", "#e0738a", "#7fae3c", "#4f97de",
] ; // prettier-ignore

/** Of cells in several of what was chosen, and in none. */
export const CROSSING = "#2f3b4c";
export const REST = "#f1eee7";

/** Row of the base complex among those of curves; valences stand before it, chords behind it (`surface/curves.py`). */
export const BASE_ROW = 5;
export const CHORD_ROW = 6;

/** Edges of the base complex, and chords. */
export const CURVE_STYLES = [
  { colour: "#20262e", ink: 1, width: 0.8 },
  ...CHOSEN.map((colour) => ({ colour, ink: 1, width: 1.25 })),
];

/** Points by their row: nodes of the graph of irregular edges, vertices of the base complex. Sizes in CSS pixels. */
export const POINT_STYLES = Object.freeze([
  { colour: "#5b6572", size: 12 },
  { colour: "#20262e", size: 6 },
]);

/** How arcs look by valence. @param {keyof typeof VALENCE_STYLES} palette */
export function arcStyles(palette) {
  return VALENCE_STYLES[palette].map(({ wire, width }) => ({ colour: wire, ink: 1, width }));
}

/** @param {number} place among what was chosen */
export const chosenColour = (place) => CHOSEN[place % CHOSEN.length];
