import { s } from "../widgets/dom.js";
import { withUnit } from "../state/units.js";
import { along } from "./histogram_layout.js";
import { tickText } from "./ticks.js";

/**
 * @typedef {import("./histogram_layout.js").Layout} Layout
 * @typedef {import("./histogram_layout.js").HistogramData} HistogramData
 *
 * @typedef {object} Look
 * @property {(position: number) => string} colour of the map
 * @property {string} ink
 * @property {string} paper
 * @property {string} quiet
 * @property {string} line
 * @property {string} rim around each bar, so that dark ones show on a dark page; "none" on a light one
 * @property {readonly [number | null, number | null] | null} acceptable
 */

/**
 * The histogram's marks as SVG, colours as attributes so that the drawing stands alone in a file.
 *
 * @param {Layout} layout @param {HistogramData} data @param {Look} look @returns {SVGElement[]}
 */
export function marks(layout, data, look) {
  return [
    ...axis(layout, look),
    ...bars(layout, data, look),
    ...steps(layout, look),
    ...bracket(layout, look),
    ...countLabel(layout, look),
    ...unitLabel(layout, look),
  ];
}

/** @param {Layout} layout @param {HistogramData} data @param {Look} look */
function bars({ bars, upright, unit }, data, { colour, rim }) {
  return bars.map(({ box, bin }) => {
    const gap = (upright ? box.width : box.height) > 3 ? 0.5 : 0;
    const inner = upright ? { ...box, width: box.width - gap } : { ...box, height: box.height - gap };
    const title = s(
      "title",
      {},
      `${tickText(Number(data.edges[bin]))} to ${withUnit(tickText(Number(data.edges[bin + 1])), unit)}: ${data.counts[bin]}`,
    );
    return s(
      "rect",
      {
        ...rounded(inner),
        fill: colour(Number(data.map_position[bin])),
        stroke: rim,
        "stroke-width": 0.5,
        class: "bar",
      },
      title,
    );
  });
}

/** A second mesh's counts, as a line with a light rim, so that it is seen on bars of any colour. @param {Layout} layout @param {Look} look */
function steps(layout, { ink, paper }) {
  if (!layout.steps.length) return [];
  const d = outline(layout);
  const look = { d, fill: "none", "stroke-linejoin": "round" };
  return [
    s("path", { ...look, stroke: paper, "stroke-width": 3.5 }),
    s("path", { ...look, stroke: ink, "stroke-width": 1.5, class: "steps" }),
  ];
}

/** @param {import("./histogram_layout.js").Box} box */
function rounded({ x, y, width, height }) {
  const two = (/** @type {number} */ value) => Math.round(value * 100) / 100;
  return { x: two(x), y: two(y), width: two(width), height: two(height) };
}

/** @param {Layout} layout @param {Look} look */
function axis({ plot, upright, ticks }, { quiet, line }) {
  const base = upright
    ? { x1: plot.x, x2: plot.x + plot.width, y1: plot.y + plot.height + 0.5, y2: plot.y + plot.height + 0.5 }
    : { x1: plot.x - 0.5, x2: plot.x - 0.5, y1: plot.y, y2: plot.y + plot.height };
  const labels = ticks.map(({ value, at }, index) => {
    const place = upright
      ? { x: at, y: plot.y + plot.height + 15, "text-anchor": anchor(at, plot, index, ticks.length) }
      : { x: plot.x - 6, y: at + 4, "text-anchor": "end" };
    return s("text", { ...place, fill: quiet, "font-size": 11 }, tickText(value));
  });
  return [s("line", { ...base, stroke: line }), ...labels];
}

/** Keeps the outermost labels inside. @param {number} at @param {{ x: number, width: number }} plot @param {number} index @param {number} count */
function anchor(at, plot, index, count) {
  if (index === 0 && at - plot.x < 8) return "start";
  if (index === count - 1 && plot.x + plot.width - at < 8) return "end";
  return "middle";
}

/** The acceptable range beside the bars. @param {Layout} layout @param {Look} look */
function bracket(layout, { acceptable, quiet }) {
  if (!acceptable) return [];
  const { plot, upright, low, high } = layout;
  const [from, to] = [acceptable[0] ?? low, acceptable[1] ?? high].map((value) =>
    along(layout, Math.min(high, Math.max(low, value))),
  );
  if (Math.abs(to - from) < 1) return [];
  const top = plot.y - 8;
  const right = plot.x + plot.width + 3;
  const path = upright
    ? `M${from} ${top + 5}V${top}H${to}V${top + 5}`
    : `M${right - 4} ${from}H${right}V${to}H${right - 4}`;
  const title = s("title", {}, "Acceptable range");
  return [s("path", { d: path, fill: "none", stroke: quiet, "stroke-width": 1, class: "bracket" }, title)];
}

/** The largest count, where its bar ends. @param {Layout} layout @param {Look} look */
function countLabel({ plot, upright, highest }, { quiet }) {
  const place = upright
    ? { x: plot.x, y: 10, "text-anchor": "start" }
    : { x: plot.x + plot.width, y: 10, "text-anchor": "end" };
  return [s("text", { ...place, fill: quiet, "font-size": 11 }, highest.toLocaleString("en-GB"))];
}

/** The unit of the values, at their axis. @param {Layout} layout @param {Look} look */
function unitLabel({ plot, upright, unit }, { quiet }) {
  if (!unit) return [];
  const place = upright
    ? { x: plot.x + plot.width / 2, y: plot.y + plot.height + 29, "text-anchor": "middle" }
    : { x: plot.x - 6, y: 10, "text-anchor": "end" };
  return [s("text", { ...place, fill: quiet, "font-size": 11, class: "unit" }, unit)];
}

/** @param {Layout} layout @returns {string} an SVG path; empty where there is no second mesh */
function outline(layout) {
  const { steps, plot, upright } = layout;
  const points = steps.map(([value, share]) => {
    const at = along(layout, value);
    return upright ? [at, plot.y + plot.height * (1 - share)] : [plot.x + plot.width * share, at];
  });
  return points.map(([x, y], k) => `${k ? "L" : "M"}${x.toFixed(2)} ${y.toFixed(2)}`).join("");
}
