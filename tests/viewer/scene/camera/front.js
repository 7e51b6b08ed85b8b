/**
 * A camera that looks at the whole model from the front.
 *
 * @type {import("../../../../static/viewer/scene/types.js").CameraStatus}
 */
export const FRONT = {
  fit: false,
  target: [0, 0, 0],
  direction: [0, 0, -1],
  up: [0, 1, 0],
  distance: 1.5,
  projection: "perspective",
  field_of_view: 30,
};
