import { h } from "../dom.js";
import { icon } from "../icons.js";

/** What the colours stand for, as the style sheet names them. */
const LEGEND = /** @type {const} */ ([
  ["crossing", "cross"],
  ["beside", "side by side"],
  ["both", "both"],
]);

/** @typedef {{ nearer: () => void, further: () => void, whole: () => void }} Zoom */

/** The buttons of the zoom. @type {readonly (readonly [keyof Zoom, name: string, icon: string])[]} */
const BUTTONS = [
  ["nearer", "Nearer", "plus"],
  ["further", "Further", "minus"],
  ["whole", "The whole matrix", "fit"],
];

/** What stands below a matrix: what its colours stand for, and buttons that zoom. @param {Zoom} zoom */
export function foot(zoom) {
  const legend = LEGEND.map(([name, words]) => h("li", { class: `pair-matrix-${name}` }, words));
  const buttons = BUTTONS.map(([way, name, sign]) =>
    h(
      "button",
      {
        type: "button",
        class: "button button-icon",
        "aria-label": name,
        title: name,
        onclick: () => zoom[way](),
      },
      icon(sign),
    ),
  );
  return h(
    "div",
    { class: "pair-matrix-foot" },
    h("ul", { class: "pair-matrix-legend" }, ...legend),
    h("div", { class: "actions", role: "group", "aria-label": "Zoom of the matrix" }, ...buttons),
  );
}
