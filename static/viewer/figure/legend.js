import { tickText } from "../charts/ticks.js";
import { largestOf } from "../charts/histogram_layout.js";
import { corners } from "../charts/steps.js";
import { s } from "../widgets/dom.js";
import { wrapped } from "./layout.js";
import { readableTicks } from "./ticks.js";

/**
 * The legend of a figure, and the histogram for print: a bar in the map's colours with its ends and round values labelled, the
 * acceptable range beside it; with bars of counts and their axis, if wanted. Lengths are in pixels of the figure.
 *
 * @typedef {import("../charts/histogram_layout.js").HistogramData} HistogramData
 *
 * @typedef {object} Scale
 * @property {HistogramData} data bins over the values, with places on the colour map
 * @property {(position: number) => string} colour
 * @property {readonly [number | null, number | null] | null} acceptable
 * @property {string} title
 * @property {readonly Key[]} keys of what is not on the map
 *
 * @typedef {{ colour: string, name: string }} Key
 *
 * @typedef {object} Style
 * @property {number} point pixels to a point (1/72 inch)
 * @property {number} size of letters, in points
 * @property {string} ink
 * @property {string} family
 * @property {boolean} counts whether bars tell how many cells there are
 * @property {"linear" | "log"} [counting]
 *
 * @typedef {{ x: number, y: number, width: number, height: number }} Box
 */

export const INK = "#1d1f23";
export const FAMILY = "Helvetica, Arial, sans-serif";

/** In points: the bar, what lies beside it, and gaps. */
const BAR = 8;
const BRACKET = 5;
const TICK = 2;
const GAP = 3;

/** Lines that a title may take. */
const MOST_LINES = 3;

/** A row of a colour and its name, in letters. */
const KEY = 1.6;

/** Least part of the counts' length that a bin with a cell has, so that it is seen. */
const LEAST = 0.01;

/**
 * Along the value's axis, and away from it: one drawing serves both directions.
 *
 * @typedef {object} Direction
 * @property {boolean} upright whether values rise upwards
 * @property {number} length of the axis
 * @property {(along: number, away: number) => [number, number]} at place in the figure
 */

/** @param {Scale} scale @param {Box} whole @param {Style} style @param {boolean} upright whether values rise upwards @returns {SVGElement[]} */
export function legend(scale, whole, style, upright) {
  const { point, size } = style;
  const letter = size * point;
  const below = scale.keys.length * KEY * letter;
  const box = { ...whole, height: whole.height - below };
  const low = Number(scale.data.edges[0]);
  const high = Number(scale.data.edges[scale.data.edges.length - 1]);
  const ends = [low, high].map((value) => tickText(value));
  const label =
    Math.max(...ends.map((text) => widthOf(text, letter)), 4 * 0.6 * letter) + (TICK + GAP) * point;
  const axis = style.counts ? 2.6 * letter + GAP * point : 0;
  const heading = wrapped(scale.title, box.width, (text) => widthOf(text, letter)).slice(0, MOST_LINES);
  const titled = heading.length ? (0.4 + 1.3 * heading.length) * letter : 0;
  const before = upright ? label + BRACKET * point : letter + (TICK + 2 * GAP) * point + BRACKET * point;
  const spread = upright ? box.width - before - 0.5 * letter : box.height - before - titled - 0.6 * letter;
  const length = upright ? box.height - titled - axis - 0.6 * letter : box.width - axis - label;
  /** @type {Direction} */
  const direction = {
    upright,
    length,
    at: upright
      ? (along, away) => [box.x + before + away, box.y + titled + 0.3 * letter + length - along]
      : (along, away) => [box.x + axis + 0.5 * label + along, box.y + box.height - before - away],
  };
  const title = heading.map((text, k) =>
    words(shortened(text, box.width, letter), box.x, box.y + (1 + 1.3 * k) * letter, {
      style,
      anchor: "start",
      weight: "bold",
    }),
  );
  return [
    ...title,
    ...strip(scale, direction, style),
    ...values(low, high, direction, style),
    ...bracket(scale, [low, high], direction, style),
    ...(style.counts ? counts(scale, direction, style, spread - BAR * point) : []),
    ...keyRows(scale.keys, { ...whole, y: box.y + box.height, height: below }, style),
  ];
}

/** Colours with their names, one below the other. @param {readonly Key[]} keys @param {Box} box @param {Style} style @returns {SVGElement[]} */
export function keyRows(keys, box, style) {
  const letter = style.size * style.point;
  return keys.flatMap(({ colour, name }, k) => {
    const y = box.y + (k + 0.3) * KEY * letter;
    return [
      s("rect", {
        x: round(box.x),
        y: round(y),
        width: round(letter),
        height: round(letter),
        fill: colour,
        stroke: style.ink,
        "stroke-width": round(0.4 * style.point),
      }),
      words(name, box.x + KEY * letter, y + 0.85 * letter, { style, anchor: "start" }),
    ];
  });
}

/** A text that is no wider than a width; an ellipsis says that there was more. @param {string} text @param {number} width @param {number} letter */
export function shortened(text, width, letter) {
  const most = Math.max(1, Math.floor(width / widthOf("n", letter)));
  return text.length <= most ? text : `${text.slice(0, most - 1).trimEnd()}…`;
}

/** Pixels that a text takes, about: of Helvetica's letters. @param {string} text @param {number} letter */
export function widthOf(text, letter) {
  return text.length * 0.56 * letter;
}

/**
 * @param {string} text @param {number} x @param {number} y
 * @param {{ style: Style, anchor: "start" | "middle" | "end", weight?: "normal" | "bold", turned?: boolean }} how
 */
export function words(text, x, y, { style, anchor, weight = "normal", turned = false }) {
  return s(
    "text",
    {
      x: round(x),
      y: round(y),
      fill: style.ink,
      "font-size": round(style.size * style.point),
      "font-family": style.family,
      "font-weight": weight,
      "text-anchor": anchor,
      ...(turned ? { transform: `rotate(-90 ${round(x)} ${round(y)})` } : {}),
    },
    text,
  );
}

/** @param {Scale} scale @param {Direction} direction @param {Style} style */
function strip({ data, colour }, direction, { point, ink }) {
  const bins = data.counts.length;
  const parts = Array.from({ length: bins }, (_, bin) => {
    const [from, to] = [(bin / bins) * direction.length, ((bin + 1) / bins) * direction.length];
    return rectangle(direction, [from, Math.min(direction.length, to + 1)], [0, BAR * point], {
      fill: colour(Number(data.map_position[bin])),
    });
  });
  const rim = rectangle(direction, [0, direction.length], [0, BAR * point], {
    fill: "none",
    stroke: ink,
    "stroke-width": round(0.4 * point),
  });
  return [...parts, rim];
}

/** @param {number} low @param {number} high @param {Direction} direction @param {Style} style */
function values(low, high, direction, style) {
  const letter = style.size * style.point;
  const widest = Math.max(
    widthOf("0.25", letter),
    ...[low, high].map((value) => widthOf(tickText(value), letter)),
  );
  const gap = direction.upright ? 1.5 * letter : widest + letter;
  const before = (BRACKET + TICK) * style.point;
  return readableTicks(low, high, direction.length, gap).flatMap((value) => {
    const along = high > low ? ((value - low) / (high - low)) * direction.length : 0;
    const [x, y] = direction.at(along, -before - GAP * style.point);
    const text = direction.upright
      ? words(tickText(value), x, y + 0.35 * letter, { style, anchor: "end" })
      : words(tickText(value), x, y + 0.8 * letter, { style, anchor: "middle" });
    return [line(direction.at(along, 0), direction.at(along, -TICK * style.point), style), text];
  });
}

/** The acceptable range beside the bar. @param {Scale} scale @param {[number, number]} ends @param {Direction} direction @param {Style} style */
function bracket({ acceptable }, [low, high], direction, style) {
  if (!acceptable || !(high > low)) return [];
  const [from, to] = [acceptable[0] ?? low, acceptable[1] ?? high].map(
    (value) => ((Math.min(high, Math.max(low, value)) - low) / (high - low)) * direction.length,
  );
  if (to - from < 1) return [];
  const [near, far] = [-(TICK + 0.5) * style.point, -(TICK + 0.5 + BRACKET / 2) * style.point];
  const corners = [
    [from, near],
    [from, far],
    [to, far],
    [to, near],
  ].map(([along, away]) => direction.at(along, away));
  const d = corners.map(([x, y], k) => `${k ? "L" : "M"}${round(x)} ${round(y)}`).join("");
  return [s("path", { d, fill: "none", stroke: style.ink, "stroke-width": round(0.5 * style.point) })];
}

/** Bars of counts on the bar's other side, and their axis. @param {Scale} scale @param {Direction} direction @param {Style} style @param {number} spread pixels that the largest count takes */
function counts({ data, colour }, direction, style, spread) {
  const all = Array.from(data.counts, Number);
  const highest = Math.max(1, largestOf(all, data.beside));
  const log = style.counting === "log";
  const share = (/** @type {number} */ n) => (log ? Math.log1p(n) / Math.log1p(highest) : n / highest);
  const base = (BAR + 1.5) * style.point;
  const room = Math.max(1, spread - 1.5 * style.point);
  const bars = all.flatMap((n, bin) => {
    if (!n) return [];
    const [from, to] = [bin / all.length, (bin + 1) / all.length].map((part) => part * direction.length);
    const far = base + Math.max(LEAST, share(n)) * room;
    return [
      rectangle(direction, [from, to], [base, far], {
        fill: colour(Number(data.map_position[bin])),
        class: "bar",
      }),
    ];
  });
  const letter = style.size * style.point;
  const widest = widthOf(highest.toLocaleString("en-GB"), letter);
  const ticks = log
    ? [0, ...powers(highest), highest]
    : readableTicks(0, highest, room, direction.upright ? 1.6 * widest : 1.5 * letter).filter(
        Number.isInteger,
      );
  const axis = line(
    direction.at(-1.5 * style.point, base),
    direction.at(-1.5 * style.point, base + room),
    style,
  );
  const labels = ticks.flatMap((n) => {
    const away = base + share(n) * room;
    const [x, y] = direction.at(-(1.5 + TICK + GAP) * style.point, away);
    return [
      line(direction.at(-1.5 * style.point, away), direction.at(-(1.5 + TICK) * style.point, away), style),
      direction.upright
        ? words(n.toLocaleString("en-GB"), x, y + 0.6 * letter, {
            style,
            anchor: n === highest ? "end" : n ? "middle" : "start",
          })
        : words(n.toLocaleString("en-GB"), x, y + 0.35 * letter, { style, anchor: "end" }),
    ];
  });
  const [x, y] = direction.at(-(1.5 + TICK + GAP) * style.point, base + room / 2);
  const name = direction.upright
    ? words("cells", x, y + 1.8 * letter, { style, anchor: "middle" })
    : words("cells", x - widest - 0.4 * letter, y, { style, anchor: "middle", turned: true });
  return [...bars, ...stepsOver(data, direction, style, { base, room, share }), axis, ...labels, name];
}

/**
 * The counts of a second mesh, as a line.
 *
 * @param {HistogramData} data @param {Direction} direction @param {Style} style
 * @param {{ base: number, room: number, share: (count: number) => number }} scale
 */
function stepsOver({ beside, edges }, direction, { ink, point }, { base, room, share }) {
  if (!beside) return [];
  const [low, high] = [Number(edges[0]), Number(edges[edges.length - 1])];
  const places = corners(beside, { low, high }, share).map(([value, height]) =>
    direction.at(((value - low) / (high - low || 1)) * direction.length, base + height * room),
  );
  const d = places.map(([x, y], k) => `${k ? "L" : "M"}${round(x)} ${round(y)}`).join("");
  const path = (/** @type {string} */ stroke, /** @type {number} */ width) =>
    s("path", { d, fill: "none", stroke, "stroke-width": round(width * point), "stroke-linejoin": "round" });
  return [path("#ffffff", 2), path(ink, 0.8)];
}

/** Powers of ten or a hundred below a number, few of them. @param {number} highest */
function powers(highest) {
  const step = highest > 1e4 ? 2 : 1;
  const found = [];
  for (let power = step; 10 ** power < highest / 3; power += step) found.push(10 ** power);
  return found;
}

/** @param {Direction} direction @param {[number, number]} along @param {[number, number]} away @param {Record<string, string | number>} look */
function rectangle(direction, along, away, look) {
  const [a, b] = [direction.at(along[0], away[0]), direction.at(along[1], away[1])];
  const [x, y] = [Math.min(a[0], b[0]), Math.min(a[1], b[1])];
  return s("rect", {
    x: round(x),
    y: round(y),
    width: round(Math.abs(a[0] - b[0])),
    height: round(Math.abs(a[1] - b[1])),
    ...look,
  });
}

/** @param {[number, number]} from @param {[number, number]} to @param {Style} style */
export function line([x1, y1], [x2, y2], { ink, point }) {
  return s("line", {
    x1: round(x1),
    y1: round(y1),
    x2: round(x2),
    y2: round(y2),
    stroke: ink,
    "stroke-width": round(0.5 * point),
  });
}

/** @param {number} value */
function round(value) {
  return Math.round(value * 100) / 100;
}
