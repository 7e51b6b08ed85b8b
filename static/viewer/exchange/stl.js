import { pointOf, trianglesOf } from "./shown_surface.js";

/** Bytes of the head, and of a triangle. */
const HEAD = 84;
const TRIANGLE = 50;

/** Binary STL: triangles in the file's coordinates, single precision, no colours. @param {import("./shown_surface.js").ShownSurface} surface @returns {Uint8Array<ArrayBuffer>} */
export function toStl(surface) {
  const triangles = trianglesOf(surface.quads, surface.points);
  const count = triangles.length / 3;
  const out = new Uint8Array(HEAD + TRIANGLE * count);
  const view = new DataView(out.buffer);
  out.set(new TextEncoder().encode("HexaLab surface").subarray(0, 80)); // must not begin with "solid"
  view.setUint32(80, count, true);
  for (let k = 0, at = HEAD; k < triangles.length; k += 3, at += TRIANGLE) {
    const corners = [0, 1, 2].map((n) => pointOf(surface, triangles[k + n]));
    [normalOf(corners), ...corners].flat().forEach((number, n) => view.setFloat32(at + 4 * n, number, true));
  }
  return out;
}

/** @param {readonly (readonly number[])[]} corners @returns {number[]} 0 0 0 of a triangle without area, as the format has it */
function normalOf([a, b, c]) {
  const [u, v] = [b, c].map((corner) => corner.map((number, axis) => number - a[axis]));
  const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
  const length = Math.hypot(...cross);
  return length > 0 ? cross.map((number) => number / length) : [0, 0, 0];
}
