import { normalised } from "./vectors.js";

/**
 * Camera settings (SPEC V6) as pure steps: views along the axes, zooming, flying to a cell.
 *
 * @typedef {import("./vectors.js").Vector} Vector
 * @typedef {import("./status.js").Status["camera"]} Camera
 */

/** Named views: direction looked in, and what is up; all of the mesh is seen. @type {Record<string, { fit: boolean, direction: Vector, up: Vector }>} */
export const VIEWS = {
  front: { fit: true, direction: [0, 0, -1], up: [0, 1, 0] },
  back: { fit: true, direction: [0, 0, 1], up: [0, 1, 0] },
  right: { fit: true, direction: [-1, 0, 0], up: [0, 1, 0] },
  left: { fit: true, direction: [1, 0, 0], up: [0, 1, 0] },
  top: { fit: true, direction: [0, -1, 0], up: [0, 0, -1] },
  bottom: { fit: true, direction: [0, 1, 0], up: [0, 0, 1] },
  isometric: { fit: true, direction: normalised([-1, -1, -1]), up: normalised([-1, 2, -1]) },
};

/** @param {Camera} camera where it stands @param {number} factor above 1 goes away */
export function zoomedCamera(camera, factor) {
  const distance = Math.min(100, Math.max(1e-4, camera.distance * factor));
  return { fit: false, target: camera.target, distance };
}

/**
 * The camera that looks at one cell from where it stands, close enough to see it among its neighbours.
 *
 * @param {Camera} camera @param {{ centre: Vector, size: number }} view in diagonals, from the core's `cell_view`
 */
export function cameraOnCell(camera, { centre, size }) {
  const halfAngle = (camera.field_of_view * Math.PI) / 360;
  return { fit: false, target: centre, distance: Math.max(1e-4, (2.5 * size) / Math.tan(halfAngle)) };
}

/**
 * The camera after a turn about an axis through what it looks at: the model turns the other way.
 *
 * @param {Pick<Camera, "direction" | "up">} camera @param {Vector} axis @param {number} angle radians
 * @returns {{ direction: Vector, up: Vector }}
 */
export function turnedCamera({ direction, up }, axis, angle) {
  const about = normalised(axis);
  return { direction: turned(direction, about, angle), up: turned(up, about, angle) };
}

/** Rodrigues' formula. @param {Vector} vector @param {Vector} axis of length 1 @param {number} angle @returns {Vector} */
function turned([x, y, z], [a, b, c], angle) {
  const [cosine, sine] = [Math.cos(angle), Math.sin(angle)];
  const along = (a * x + b * y + c * z) * (1 - cosine);
  return [
    x * cosine + (b * z - c * y) * sine + a * along,
    y * cosine + (c * x - a * z) * sine + b * along,
    z * cosine + (a * y - b * x) * sine + c * along,
  ];
}
