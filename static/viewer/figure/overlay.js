import { tickText } from "../charts/ticks.js";
import { withUnit } from "../state/units.js";
import { line, shortened, words } from "./legend.js";

/**
 * What stands over a picture of a figure: scale bar, axes, the panel's letter.
 *
 * @typedef {import("./layout.js").Box} Box
 * @typedef {import("./legend.js").Style} Style
 * @typedef {{ pixels: number, unit: string }} ScaleBar  pixels to a length of 1 in the file's unit, and that unit's name; may be empty
 * @typedef {"bottom_left" | "bottom_right" | "top_left" | "top_right"} Corner
 */

/** Longest scale bar, as a part of the picture's width. */
const LONGEST = 0.28;

/** Colours of x, y, z: those of the axes on the screen. */
const AXES = ["#c8372d", "#2f7d4f", "#2f5fc0"];

/**
 * A round length, 1, 2 or 5 times a power of ten, that is no longer than a length.
 *
 * @param {number} longest
 */
export function roundLength(longest) {
  const power = 10 ** Math.floor(Math.log10(longest));
  return power * ([5, 2, 1].find((factor) => factor * power <= longest * (1 + 1e-9)) ?? 1);
}

/** @param {Box} box @param {Corner} corner @param {number} aside @returns {{ x: number, y: number, right: boolean, top: boolean }} */
function cornerOf(box, corner, aside) {
  const [right, top] = [corner.endsWith("right"), corner.startsWith("top")];
  return {
    x: right ? box.x + box.width - aside : box.x + aside,
    y: top ? box.y + aside : box.y + box.height - aside,
    right,
    top,
  };
}

/**
 * @param {Box} box @param {Corner} corner @param {ScaleBar} bar @param {Style} style
 * @returns {SVGElement[]}
 */
export function scaleBar(box, corner, { pixels, unit }, style) {
  const letter = style.size * style.point;
  const length = roundLength((LONGEST * box.width) / pixels);
  const { x, y, right, top } = cornerOf(box, corner, letter);
  const [from, to] = right ? [x - length * pixels, x] : [x, x + length * pixels];
  const base = top ? y + 1.4 * letter : y;
  const end = 0.3 * letter;
  return [
    line([from, base], [to, base], style),
    line([from, base - end], [from, base + end], style),
    line([to, base - end], [to, base + end], style),
    words(withUnit(tickText(length), unit), (from + to) / 2, base - 0.55 * letter, {
      style,
      anchor: "middle",
    }),
  ];
}

/**
 * @param {Box} box @param {Corner} corner
 * @param {readonly (readonly [number, number, number])[]} tips of the axes of length 1 in the view's frame: right, up, to the eye
 * @param {Style} style
 * @returns {SVGElement[]}
 */
export function axes(box, corner, tips, style) {
  const letter = style.size * style.point;
  const reach = Math.min(4 * letter, 0.18 * Math.min(box.width, box.height));
  const { x, y } = cornerOf(box, corner, reach + 1.6 * letter);
  const order = [0, 1, 2].sort((a, b) => tips[a][2] - tips[b][2]);
  return order.flatMap((axis) => {
    const [right, up] = tips[axis];
    const end = /** @type {[number, number]} */ ([x + reach * right, y - reach * up]);
    const ink = { ...style, ink: AXES[axis] };
    const away = reach + 0.75 * letter;
    return [
      thick(line([x, y], end, ink), style),
      words("xyz"[axis], x + away * right, y - away * up + 0.3 * letter, { style: ink, anchor: "middle" }),
    ];
  });
}

/** @param {SVGElement} element @param {Style} style */
function thick(element, { point }) {
  element.setAttribute("stroke-width", String(Math.round(120 * point) / 100));
  element.setAttribute("stroke-linecap", "round");
  return element;
}

/**
 * What stands below a picture, such as "a)": in its middle, or two words at its sides.
 *
 * @param {Box} box @param {readonly string[]} texts one or two @param {Style} style @returns {SVGElement[]}
 */
export function label(box, texts, style) {
  const letter = style.size * style.point;
  const y = box.y + box.height + 1.1 * letter;
  const rim = texts.length > 1 ? letter / 2 : 0;
  const fitting = (/** @type {string} */ text) => shortened(text, box.width / texts.length - rim, letter);
  const [first, second] = texts;
  if (second === undefined)
    return [words(fitting(first), box.x + box.width / 2, y, { style, anchor: "middle" })];
  return [
    words(fitting(first), box.x + rim, y, { style, anchor: "start" }),
    words(fitting(second), box.x + box.width - rim, y, { style, anchor: "end" }),
  ];
}
