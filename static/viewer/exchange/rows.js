import { pointOf, same } from "./shown_surface.js";
import { welded } from "./welded.js";

/**
 * Vertices in the file's coordinates and the faces over them: what formats have that share vertices between faces.
 *
 * @param {import("./shown_surface.js").ShownSurface} surface
 * @returns {{ vertices: { point: [number, number, number], colour: number[] }[], faces: number[][] }}
 */
export function cornersOf(surface) {
  const { points, quads, colours } = surface;
  const { ids, firsts } = welded(points, colours);
  const vertices = Array.from(firsts, (corner) => ({
    point: pointOf(surface, corner),
    colour: [...colours.subarray(3 * corner, 3 * corner + 3)],
  }));
  const faces = [];
  for (let k = 0; k < quads.length; k += 4) {
    const corners = [...quads.subarray(k, k + 4)];
    if (same(points, corners[2], corners[3])) corners.pop();
    faces.push(corners.map((corner) => ids[corner]));
  }
  return { vertices, faces };
}
