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
