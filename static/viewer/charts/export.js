import { s } from "../widgets/dom.js";
import { layOut } from "./histogram_layout.js";
import { marks } from "./histogram_svg.js";

/**
 * The histogram as files (SPEC Q4). The drawing is black on white whatever the page's scheme.
 *
 * @typedef {import("./histogram_layout.js").HistogramData} HistogramData
 * @typedef {{ orientation: "horizontal" | "vertical", scale: "linear" | "log", title: string, colour: (position: number) => string,
 *   acceptable: readonly [number | null, number | null] | null }} Style
 */

const SIZES = { horizontal: [640, 320], vertical: [320, 640] };

/** @param {HistogramData} data @param {Style} style @returns {string} */
export function toSvg(data, { orientation, scale, title, colour, acceptable }) {
  const [width, height] = SIZES[orientation];
  const heading = 24;
  const layout = layOut(data, { width, height: height - heading, orientation, scale });
  const look = { colour, ink: "#1d1f23", quiet: "#5d6167", line: "#1d1f23", acceptable };
  const svg = s(
    "svg",
    {
      xmlns: "http://www.w3.org/2000/svg",
      viewBox: `0 0 ${width} ${height}`,
      width,
      height,
      "font-family": "sans-serif",
    },
    s("rect", { width, height, fill: "#ffffff" }),
    s("text", { x: 8, y: 18, "font-size": 13, fill: look.ink }, title),
    s("g", { transform: `translate(0 ${heading})` }, ...marks(layout, data, look)),
  );
  return new XMLSerializer().serializeToString(svg);
}

/** One row per bin: lower edge, upper edge, count; the head names what was measured. @param {HistogramData} data @param {string} quantity @returns {string} */
export function toCsv(data, quantity) {
  const rows = Array.from(data.counts, (count, bin) => `${data.edges[bin]},${data.edges[bin + 1]},${count}`);
  const name = /[",]/.test(quantity) ? quantity.replaceAll(/[",]/g, " ") : quantity;
  return [`${name} low,${name} high,cells`, ...rows, ""].join("\r\n");
}

/** @param {string} svg @param {number} [scale] pixels per unit @returns {Promise<Blob>} */
export async function toPng(svg, scale = 4) {
  const address = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
  try {
    const image = new Image();
    image.src = address;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth * scale;
    canvas.height = image.naturalHeight * scale;
    canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
    return await new Promise((resolve, reject) =>
      canvas.toBlob(
        (blob) => (blob ? resolve(blob) : reject(new Error("the histogram could not be drawn as PNG"))),
        "image/png",
      ),
    );
  } finally {
    URL.revokeObjectURL(address);
  }
}
