import { cornersOf } from "./rows.js";

/** Lines that are joined at a time. */
const LINES = 65_536;

/**
 * Wavefront OBJ: vertices with their colours behind the coordinates (as MeshLab, Blender and Open3D read and write them), faces of
 * three and four corners.
 *
 * @param {import("./shown_surface.js").ShownSurface} surface @returns {Uint8Array<ArrayBuffer>}
 */
export function toObj(surface) {
  const { vertices, faces } = cornersOf(surface);
  const comments = ["HexaLab", surface.name, surface.reference].filter(Boolean);
  const lines = comments.map((line) => `# ${line.replaceAll(/[\r\n]+/g, " ")}`);
  /** @type {string[]} */
  const parts = [];
  const flush = () => parts.push(`${lines.splice(0).join("\n")}\n`);
  for (const { point, colour } of vertices) {
    lines.push(`v ${point.join(" ")} ${colour.map((part) => (part / 255).toFixed(4)).join(" ")}`);
    if (lines.length > LINES) flush();
  }
  for (const face of faces) {
    lines.push(`f ${face.map((corner) => corner + 1).join(" ")}`);
    if (lines.length > LINES) flush();
  }
  flush();
  return new TextEncoder().encode(parts.join(""));
}
