// biome-ignore lint/correctness/noUnresolvedImports: its package.json names the types by a condition that Biome does not follow
import { jsPDF as JsPdf } from "jspdf";
import "svg2pdf.js";

/**
 * A figure as PDF, its words as text.
 *
 * @param {SVGElement} svg
 * @param {number} width in points
 * @param {number} height
 * @returns {Promise<Blob>}
 */
export async function toPdf(svg, width, height) {
  const page = new JsPdf({
    unit: "pt",
    format: [width, height],
    orientation: width > height ? "landscape" : "portrait",
    compress: true,
  });
  await page.svg(svg, { x: 0, y: 0, width, height });
  return page.output("blob");
}
