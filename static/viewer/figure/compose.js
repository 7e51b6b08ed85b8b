import { s } from "../widgets/dom.js";
import { keyRows, legend, words } from "./legend.js";
import { lineAt } from "./layout.js";
import { axes, label, scaleBar } from "./overlay.js";

/**
 * A figure as SVG: pictures inside, words as text.
 *
 * @typedef {import("./layout.js").Layout} Layout
 * @typedef {import("./legend.js").Style} Style
 * @typedef {import("./legend.js").Scale} Scale
 *
 * @typedef {object} Figure
 * @property {number} width pixels
 * @property {number} height
 * @property {string} background "none" where it is transparent
 * @property {Layout} layout
 * @property {Style} style
 * @property {readonly (readonly string[])[]} labels below each picture; none where nothing stands there
 * @property {Scale | { colours: { colour: string, name: string }[], title: string } | null} scale what the legend tells
 * @property {import("./overlay.js").ScaleBar & { corner: import("./overlay.js").Corner } | null} scaleBar in the first picture, or the last
 * @property {{ corner: import("./overlay.js").Corner, tips: [number, number, number][] } | null} axes
 * @property {string[]} caption its lines
 */

/**
 * @param {Figure} figure
 * @param {readonly string[]} pictures their addresses; none: what stands around and over them alone
 * @returns {SVGElement}
 */
export function composed(figure, pictures = []) {
  const { width, height, background, layout, style } = figure;
  const images = pictures.map((href, k) => s("image", { ...layout.pictures[k], href }));
  const ground =
    pictures.length && background !== "none" ? [s("rect", { width, height, fill: background })] : [];
  const svg = s(
    "svg",
    { xmlns: "http://www.w3.org/2000/svg", viewBox: `0 0 ${width} ${height}`, width, height },
    ...ground,
    ...images,
    ...over(figure),
  );
  return lettered(svg, style);
}

/** @param {Figure} figure @returns {SVGElement[]} */
function over({ layout, style, labels, scale, scaleBar: bar, axes: directions, caption }) {
  const [first] = layout.pictures;
  const last = layout.pictures[layout.pictures.length - 1];
  const letter = style.size * style.point;
  return [
    ...labels.flatMap((texts, k) => label(layout.pictures[k], texts, style)),
    ...(bar ? scaleBar(bar.corner.endsWith("left") ? first : last, bar.corner, bar, style) : []),
    ...(directions
      ? axes(directions.corner.endsWith("left") ? first : last, directions.corner, directions.tips, style)
      : []),
    ...(layout.legend && scale ? legendOf(scale, layout.legend, style) : []),
    ...(layout.caption
      ? caption.map((text, k) => {
          const [x, y] = lineAt(/** @type {import("./layout.js").Box} */ (layout.caption), k, letter);
          return words(text, x, y, { style, anchor: "start" });
        })
      : []),
  ];
}

/**
 * The legend by itself.
 *
 * @param {NonNullable<Figure["scale"]>} scale @param {{ width: number, height: number }} size pixels @param {Style} style @returns {SVGElement}
 */
export function legendAlone(scale, { width, height }, style) {
  const svg = s(
    "svg",
    { xmlns: "http://www.w3.org/2000/svg", viewBox: `0 0 ${width} ${height}`, width, height },
    ...legendOf(scale, { x: 0, y: 0, width, height }, style),
  );
  return lettered(svg, style);
}

/** @param {SVGElement} svg @param {Style} style */
function lettered(svg, { family }) {
  for (const text of svg.querySelectorAll("text")) text.setAttribute("font-family", family);
  return svg;
}

/** @param {NonNullable<Figure["scale"]>} scale @param {import("./layout.js").Box} box @param {Style} style @returns {SVGElement[]} */
function legendOf(scale, box, style) {
  if ("data" in scale) return legend(scale, box, style, true);
  const letter = style.size * style.point;
  if (!scale.title) return keyRows(scale.colours, box, style);
  return [
    words(scale.title, box.x, box.y + letter, { style, anchor: "start", weight: "bold" }),
    ...keyRows(scale.colours, { ...box, y: box.y + 1.5 * letter }, style),
  ];
}

/** @param {SVGElement} svg */
export function textOf(svg) {
  return new XMLSerializer().serializeToString(svg);
}
