/**
 * The shapes of what the scene is given. Lengths are in diagonals of the mesh's frame, whose centre is the origin.
 *
 * @typedef {import("../state/vectors.js").Vector} Vector
 * @typedef {import("../state/status.js").Status} Status
 * @typedef {Status["camera"]} CameraStatus
 *
 * What the scene draws by: a whole status, or any of its settings with the camera whole.
 *
 * @typedef {import("../state/status.js").PartialStatus & { camera?: CameraStatus }} SceneStatus
 *
 * @typedef {object} Plane
 * @property {Vector} normal
 * @property {number} offset from 0 to 1 over the extent
 * @property {readonly number[]} [extent] least and greatest distance from the origin along the normal, in diagonals; the
 *   mesh's box
 */

export {};
