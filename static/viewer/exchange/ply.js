import { cornersOf } from "./rows.js";

/** Bytes of a vertex: three float64, three colours. */
const VERTEX = 27;

/** Binary PLY: vertices with their colours, faces of three and four corners, double precision. @param {import("./shown_surface.js").ShownSurface} surface @returns {Uint8Array<ArrayBuffer>} */
export function toPly(surface) {
  const { vertices, faces } = cornersOf(surface);
  const comments = [surface.name, surface.reference].filter(Boolean).map((line) => `comment ${line}`);
  const head = [
    "ply",
    "format binary_little_endian 1.0",
    "comment HexaLab",
    ...comments.map((line) => line.replaceAll(/[\r\n]+/g, " ")),
    `element vertex ${vertices.length}`,
    ...["x", "y", "z"].map((axis) => `property double ${axis}`),
    ...["red", "green", "blue"].map((part) => `property uchar ${part}`),
    `element face ${faces.length}`,
    "property list uchar int vertex_indices",
    "end_header\n",
  ].join("\n");
  const encoded = new TextEncoder().encode(head);
  const corners = faces.reduce((total, face) => total + face.length, 0);
  const out = new Uint8Array(encoded.length + VERTEX * vertices.length + faces.length + 4 * corners);
  const view = new DataView(out.buffer);
  out.set(encoded);
  let at = encoded.length;
  for (const { point, colour } of vertices) {
    point.forEach((number, axis) => view.setFloat64(at + 8 * axis, number, true));
    out.set(colour, at + 24);
    at += VERTEX;
  }
  for (const face of faces) {
    out[at++] = face.length;
    for (const corner of face) {
      view.setInt32(at, corner, true);
      at += 4;
    }
  }
  return out;
}
