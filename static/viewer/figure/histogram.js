import { s } from "../widgets/dom.js";
import { INK, legend } from "./legend.js";

/** Families of letters that every program has. */
const FAMILIES = { sans: "Helvetica, Arial, sans-serif", serif: "Times, 'Times New Roman', serif" };

const POINTS = 72;
const MILLIMETRES = 25.4;

/** Blank around it, in points. */
const RIM = 4;

/**
 * The histogram for print: black on white whatever the page's scheme, in points.
 *
 * @param {import("./legend.js").Scale} scale
 * @param {import("../state/status.js").Status["histogram"]} look
 * @returns {{ svg: SVGElement, width: number, height: number }} in points
 */
export function printed(scale, { width, height, letters, font, orientation, scale: counting }) {
  const [wide, high] = [width, height].map((side) => (side / MILLIMETRES) * POINTS);
  const style = { point: 1, size: letters, ink: INK, family: FAMILIES[font], counts: true, counting };
  const box = { x: RIM, y: RIM, width: wide - 2 * RIM, height: high - 2 * RIM };
  const marks = legend(scale, box, style, orientation === "vertical");
  const svg = s(
    "svg",
    {
      xmlns: "http://www.w3.org/2000/svg",
      viewBox: `0 0 ${wide} ${high}`,
      width: `${width}mm`,
      height: `${height}mm`,
    },
    s("rect", { width: wide, height: high, fill: "#ffffff" }),
    ...marks,
  );
  return { svg, width: wide, height: high };
}
