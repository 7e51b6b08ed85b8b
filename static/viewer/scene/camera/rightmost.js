import { Vector3 } from "three";

/**
 * The rightmost of some points as a camera sees them.
 *
 * @param {ArrayLike<number>} points three numbers each @param {import("three").Camera} camera
 * @param {{ width: number, height: number }} size of the picture
 * @returns {import("../scene_like.js").Place | null} in its pixels, from left and top; null where none is before the eye
 */
export function rightmostOf(points, camera, { width, height }) {
  const place = new Vector3();
  let at = null;
  for (let k = 0; k < points.length; k += 3) {
    place.set(points[k], points[k + 1], points[k + 2]).project(camera);
    const x = ((place.x + 1) / 2) * width;
    if (Math.abs(place.z) <= 1 && x > (at?.x ?? -Infinity)) at = { x, y: ((1 - place.y) / 2) * height };
  }
  return at;
}
