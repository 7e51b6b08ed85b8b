/**
 * Where a mesh's drawing coordinates lie: those of two meshes differ, since each is drawn in its own frame.
 *
 * @typedef {import("./vectors.js").Vector} Vector
 * @typedef {import("./status.js").Status["camera"]} Camera
 * @typedef {{ centre: readonly number[], diagonal: number }} Frame  in the file's unit
 */

/** Part of a diagonal by which frames may differ that are nearly the same. */
const NEARLY = 0.05;

/** Whether two bodies are at nearly the same place, and nearly as large. @param {Frame} a @param {Frame} b */
export function areAlike(a, b) {
  const apart = Math.hypot(...a.centre.map((place, axis) => place - b.centre[axis]));
  return apart < NEARLY * a.diagonal && Math.abs(b.diagonal / a.diagonal - 1) < NEARLY;
}

/** Part of a diagonal by which bodies may be apart that are seen in one picture. */
const NEAR = 2;

/** Whether one picture can show both bodies: neither is far from the other, or very small beside it. @param {Frame} a @param {Frame} b */
export function areNear(a, b) {
  const apart = Math.hypot(...a.centre.map((place, axis) => place - b.centre[axis]));
  const [small, large] = [a.diagonal, b.diagonal].sort((one, other) => one - other);
  return apart < NEAR * large && large < 2 * NEAR * small;
}

/** The frame of a box, and its corners in drawing coordinates of another. @param {readonly (readonly number[])[]} extent two corners @returns {Frame} */
export function frameOfBox([low, high]) {
  return {
    centre: low.map((end, axis) => (end + high[axis]) / 2),
    diagonal: Math.hypot(...low.map((end, axis) => high[axis] - end)) || 1,
  };
}

/** A place in the drawing coordinates of another frame. @param {readonly number[]} place @param {Frame} from @param {Frame} to @returns {Vector} */
export function placeIn(place, from, to) {
  const [x, y, z] = [0, 1, 2].map(
    (axis) => (place[axis] * from.diagonal + from.centre[axis] - to.centre[axis]) / to.diagonal,
  );
  return [x, y, z];
}

/**
 * The same camera in another frame: what it sees stands where it stood.
 *
 * @template {Partial<Camera>} Part @param {Part} camera @param {Frame} from @param {Frame} to @returns {Part}
 */
export function cameraIn(camera, from, to) {
  const { target, distance } = camera;
  return {
    ...camera,
    ...(target ? { target: placeIn(target, from, to) } : {}),
    ...(distance === undefined ? {} : { distance: (distance * from.diagonal) / to.diagonal }),
  };
}

/** Points in another frame. @param {Float32Array} points 3 coordinates each @param {Frame} from @param {Frame} to */
export function pointsIn(points, from, to) {
  const scale = from.diagonal / to.diagonal;
  const moved = from.centre.map((place, axis) => (place - to.centre[axis]) / to.diagonal);
  return points.map((place, k) => place * scale + moved[k % 3]);
}
