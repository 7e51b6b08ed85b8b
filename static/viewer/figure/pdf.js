// biome-ignore lint/correctness/noUnresolvedImports: its package.json names the types by a condition that Biome does not follow
import { jsPDF as JsPdf } from "jspdf";
import "svg2pdf.js";

/** What is not among the letters of a PDF's own fonts (Windows code page 1252). */
const FOREIGN = /[^\u0020-\u007e\u00a0-\u00ff–—‘’‚“”„†‡•…‰‹›€™ŒœŠšŸŽžƒˆ˜]/u;

/**
 * A figure as PDF, its words as text in one of the fonts that every reader has.
 *
 * @throws {Error} a word has letters that these fonts lack: which
 * @param {SVGElement} svg
 * @param {number} width in points
 * @param {number} height
 * @returns {Promise<Blob>}
 */
export async function toPdf(svg, width, height) {
  for (const text of svg.querySelectorAll("text")) {
    text.textContent = (text.textContent ?? "").replaceAll("−", "–"); // they have no minus but a dash of its length
    const [letter] = FOREIGN.exec(text.textContent) ?? [];
    if (letter)
      throw new Error(`a PDF's own fonts have no ‘${letter}’: save SVG or PNG, or write it otherwise`);
  }
  const page = new JsPdf({
    unit: "pt",
    format: [width, height],
    orientation: width > height ? "landscape" : "portrait",
    compress: true,
  });
  await page.svg(svg, { x: 0, y: 0, width, height });
  return page.output("blob");
}
