/**
 * The shapes of what the scene is given. Lengths are in diagonals of the mesh, whose extent's centre is the origin.
 *
 * @typedef {import("../state/vectors.js").Vector} Vector
 *
 * @typedef {import("../state/status.js").Status["camera"]} CameraStatus
 *
 * @typedef {object} ColourStatus
 * @property {"sides" | "quality" | "attribute" | "kind"} by
 * @property {string} outside
 * @property {string} inside
 * @property {string} map
 *
 * @typedef {object} SceneStatus the part of the status document that the scene draws
 * @property {CameraStatus} [camera]
 * @property {{ line_opacity?: number, line_width?: number }} [separation]
 * @property {Partial<ColourStatus>} [colour]
 * @property {number} [silhouette]
 * @property {{ mode?: number, boundary?: boolean }} [irregular]
 * @property {{ mode?: import("../lighting/lighting.js").LightingMode }} [lighting]
 * @property {string} [background]
 *
 * @typedef {object} Plane
 * @property {Vector} normal
 * @property {number} offset from 0 to 1 over the extent
 * @property {readonly number[]} [extent] least and greatest distance from the origin along the normal, in diagonals; the
 *   mesh's box
 */

export {};
