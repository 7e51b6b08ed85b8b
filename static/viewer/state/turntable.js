import { turnedCamera } from "./camera.js";

/**
 * The cameras of a turntable: they go once around what is upright.
 *
 * @typedef {import("./vectors.js").Vector} Vector
 * @typedef {import("./status.js").Status["camera"]} Camera
 */

/** Part of the picture that the body fills at most. */
const FILLED = 0.95;

/**
 * A camera that is fitted to the mesh stands as far off as the widest view needs, so that nothing leaves the picture and nothing
 * breathes; one that was moved by hand keeps its target and distance.
 *
 * @param {Camera} camera the first one @param {number} frames
 * @param {{ axis: Vector, body: ArrayLike<number>, aspect: number }} scene what is upright; points that stand for the mesh, in
 *   drawing coordinates; the picture's width over its height
 * @returns {Camera[]}
 */
export function turntable(camera, frames, { axis, body, aspect }) {
  const turned = Array.from({ length: frames }, (_, frame) => ({
    ...camera,
    ...turnedCamera(camera, axis, (2 * Math.PI * frame) / frames),
    fit: false,
  }));
  if (!camera.fit || !body.length) return turned;
  /** @type {Vector} */
  const target = [0, 0, 0];
  const distance = Math.max(...turned.map((one) => needed(one, body, aspect)));
  return turned.map((one) => ({ ...one, target, distance }));
}

/** The least distance from the origin at which a camera sees all points. @param {Camera} camera @param {ArrayLike<number>} body @param {number} aspect */
function needed({ direction, up, field_of_view, projection }, body, aspect) {
  const slope = Math.tan((field_of_view * Math.PI) / 360) * FILLED;
  const [right, upright] = screen(direction, up);
  const ahead = length(direction);
  let distance = 0;
  for (let k = 0; k < body.length; k += 3) {
    const along = (/** @type {Vector} */ axis) =>
      axis[0] * body[k] + axis[1] * body[k + 1] + axis[2] * body[k + 2];
    const aside = Math.max(Math.abs(along(right)) / aspect, Math.abs(along(upright))) / slope;
    const nearer = projection === "perspective" ? -along(direction) / ahead : 0;
    distance = Math.max(distance, aside + nearer);
  }
  return distance;
}

/** What is right and what is up on the screen, of length 1. @param {Vector} direction @param {Vector} up @returns {[Vector, Vector]} */
function screen(direction, up) {
  const right = unit(cross(direction, up));
  return [right, unit(cross(right, direction))];
}

/** @param {Vector} a @param {Vector} b @returns {Vector} */
function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** @param {Vector} a */
const length = (a) => Math.hypot(...a) || 1;

/** @param {Vector} a @returns {Vector} */
function unit(a) {
  const size = length(a);
  return [a[0] / size, a[1] / size, a[2] / size];
}
