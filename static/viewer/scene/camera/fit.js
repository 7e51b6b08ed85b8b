import { Box3, MathUtils, Vector3 } from "three";

/** Part of the picture, along the side that is the tighter one, that a box may fill. */
export const FILLED = 0.95;

/** Steps towards the middle of what perspective makes of a body: each halves what is left, at least. */
const STEPS = 8;

/** Least distance: a single point is seen from somewhere. */
const LEAST = 1e-6;

/**
 * Where a camera of a given direction stands so that a body fills its picture, in the middle, with a margin all round.
 *
 * @param {ArrayLike<number>} points 3 coordinates for each, at least one: those of the body that stand out
 * @param {import("three").Quaternion} orientation
 * @param {{ fieldOfView: number, aspect: number, projection: "perspective" | "orthographic", filled?: number }} lens
 *   vertical, in degrees; width over height; part of the picture that is filled
 * @returns {{ target: Vector3, distance: number }}
 */
export function fitted(points, orientation, { fieldOfView, aspect, projection, filled = FILLED }) {
  const back = orientation.clone().invert();
  const seen = Array.from({ length: points.length / 3 }, (_, k) =>
    new Vector3(points[3 * k], points[3 * k + 1], points[3 * k + 2]).applyQuaternion(back),
  ); // x right, y up, z to the eye
  const slope = Math.tan(MathUtils.degToRad(fieldOfView) / 2) * filled;
  const perspective = projection === "perspective" ? 1 : 0;
  const middle = new Box3().setFromPoints(seen).getCenter(new Vector3());
  let distance = LEAST;
  for (let step = 0; step < (perspective ? STEPS : 1); step++) {
    distance = LEAST;
    for (const { x, y, z } of seen) {
      const aside = Math.max(Math.abs(x - middle.x) / aspect, Math.abs(y - middle.y)) / slope;
      distance = Math.max(distance, aside + perspective * (z - middle.z));
    }
    if (!perspective) break;
    for (const side of /** @type {const} */ (["x", "y"])) {
      let [least, most] = [Infinity, -Infinity];
      for (const point of seen) {
        const place = (point[side] - middle[side]) / Math.max(LEAST, distance - point.z + middle.z);
        least = Math.min(least, place);
        most = Math.max(most, place);
      }
      middle[side] += (distance * (most + least)) / 2;
    }
  }
  return { target: middle.applyQuaternion(orientation), distance };
}
