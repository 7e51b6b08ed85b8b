/**
 * Where the parts of a figure stand, in its pixels: pictures in a row, a legend beside them, a caption below.
 *
 * @typedef {{ x: number, y: number, width: number, height: number }} Box
 *
 * @typedef {object} Asked
 * @property {number} width
 * @property {number} height
 * @property {number} point pixels to a point
 * @property {number} letters size in points
 * @property {number} margin in points
 * @property {number} panels how many pictures
 * @property {boolean} lettered whether each has its letter below
 * @property {"none" | "bar" | "histogram" | "list"} legend
 * @property {"left" | "right"} legendPlace
 * @property {number} lines of the caption
 *
 * @typedef {{ pictures: Box[], legend: Box | null, caption: Box | null }} Layout
 */

/** Width of a legend, in letters. */
const LEGENDS = { none: 0, bar: 8, histogram: 15, list: 11 };

/** Height of a line of the caption, in letters. */
const LINE = 1.35;

/** Between parts, in letters. */
const GAP = 0.8;

/** Least side of a picture, in pixels. */
const LEAST = 16;

/** @param {Asked} asked @returns {Layout} @throws {Error} what stands around leaves no room for the pictures */
export function layOut({
  width,
  height,
  point,
  letters,
  margin,
  panels,
  lettered,
  legend,
  legendPlace,
  lines,
}) {
  const letter = letters * point;
  const rim = margin * point;
  const gap = GAP * letter;
  const beside = legend === "none" ? 0 : LEGENDS[legend] * letter;
  const strip = lettered ? LINE * letter : 0;
  const below = (lines ? lines * LINE * letter + gap : 0) + strip;
  const inner = {
    x: rim + (legendPlace === "left" && beside ? beside + gap : 0),
    y: rim,
    width: width - 2 * rim - (beside ? beside + gap : 0),
    height: height - 2 * rim - below,
  };
  const each = (inner.width - (panels - 1) * gap) / panels;
  if (each < LEAST || inner.height < LEAST)
    throw new Error(
      "what stands around the picture leaves no room for it: make the figure larger, or the letters smaller",
    );
  const pictures = Array.from({ length: panels }, (_, k) =>
    whole({ x: inner.x + k * (each + gap), y: inner.y, width: each, height: inner.height }),
  );
  const side = {
    x: legendPlace === "left" ? rim : width - rim - beside,
    y: inner.y + 0.2 * letter,
    width: beside,
    height: inner.height - 0.4 * letter,
  };
  const caption = {
    x: rim,
    y: inner.y + inner.height + strip + gap,
    width: width - 2 * rim,
    height: below - strip - gap,
  };
  return { pictures, legend: beside ? side : null, caption: lines ? caption : null };
}

/** On whole pixels, as a picture is. @param {Box} box @returns {Box} */
function whole({ x, y, width, height }) {
  const [left, top] = [Math.round(x), Math.round(y)];
  return {
    x: left,
    y: top,
    width: Math.max(1, Math.round(x + width) - left),
    height: Math.max(1, Math.round(y + height) - top),
  };
}

/** Place of a line of the caption. @param {Box} caption @param {number} line @param {number} letter @returns {[number, number]} */
export function lineAt({ x, y }, line, letter) {
  return [x, y + (line * LINE + 1) * letter];
}

/**
 * A text in lines that are no wider than a width.
 *
 * @param {string} text @param {number} width @param {(text: string) => number} measure
 * @returns {string[]}
 */
export function wrapped(text, width, measure) {
  /** @type {string[]} */
  const lines = [];
  for (const word of text.split(/\s+/).filter(Boolean)) {
    const last = lines.at(-1);
    if (last !== undefined && measure(`${last} ${word}`) <= width)
      lines[lines.length - 1] = `${last} ${word}`;
    else lines.push(word);
  }
  return lines;
}
