import assert from "node:assert/strict";
import { test } from "node:test";
import { PerspectiveCamera, OrthographicCamera, Vector3 } from "three";
import { turnedCamera } from "../../../static/viewer/state/camera.js";
import { turntable } from "../../../static/viewer/state/turntable.js";

/** @typedef {import("../../../static/viewer/state/status.js").Status["camera"]} Camera @typedef {import("../../../static/viewer/state/vectors.js").Vector} Vector */

/** @type {Camera} */
const CAMERA = {
  fit: true,
  target: [0.1, 0, 0],
  direction: [-0.5, 0.8, -0.45],
  up: [0, 0, 1],
  distance: 2,
  projection: "perspective",
  field_of_view: 30,
};

/** @type {Vector} */
const UP = [0, 0, 1];
const BODY = [-0.4, -0.1, -0.2, 0.4, 0.1, 0.2, 0.4, -0.1, 0.2, -0.4, 0.1, -0.2, 0, 0, 0.3];

/** Where a camera of three's puts a point: -1 to 1 within the picture. @param {Camera} camera @param {number[]} point @param {number} aspect */
function seen({ direction, up, target, distance, projection, field_of_view }, point, aspect) {
  const half = distance * Math.tan((field_of_view * Math.PI) / 360);
  const camera =
    projection === "perspective"
      ? new PerspectiveCamera(field_of_view, aspect, 0.01, 100)
      : new OrthographicCamera(-half * aspect, half * aspect, half, -half, 0.01, 100);
  const middle = new Vector3().fromArray(target);
  camera.up.fromArray(up);
  camera.position.copy(middle).addScaledVector(new Vector3().fromArray(direction).normalize(), -distance);
  camera.lookAt(middle);
  camera.updateMatrixWorld(true);
  return new Vector3().fromArray(point).project(camera);
}

for (const projection of /** @type {const} */ (["perspective", "orthographic"]))
  for (const aspect of [0.6, 1.7])
    test(`A8 a turntable keeps the body in the picture, ${projection}, ${aspect}`, () => {
      const cameras = turntable({ ...CAMERA, projection }, 24, { axis: UP, body: BODY, aspect });
      let widest = 0;
      for (const camera of cameras) {
        assert.equal(camera.distance, cameras[0].distance);
        for (let k = 0; k < BODY.length; k += 3) {
          const { x, y } = seen(camera, BODY.slice(k, k + 3), aspect);
          widest = Math.max(widest, Math.abs(x), Math.abs(y));
        }
      }
      assert.ok(widest < 0.951 && widest > 0.93, `fills ${widest}`);
    });

test("A8 it turns once, evenly, about the axis, and begins where the camera is", () => {
  const cameras = turntable({ ...CAMERA, fit: false }, 4, { axis: UP, body: BODY, aspect: 1 });
  const near = (/** @type {readonly number[]} */ a, /** @type {readonly number[]} */ b) =>
    a.forEach((part, k) => assert.ok(Math.abs(part - b[k]) < 1e-12, `${a} is not ${b}`));
  near(cameras[0].direction, CAMERA.direction);
  near(cameras[1].direction, [-0.8, -0.5, -0.45]);
  near(cameras[2].direction, [0.5, -0.8, -0.45]);
  for (const { up, target, distance } of cameras) {
    near(up, UP);
    assert.deepEqual([target, distance], [CAMERA.target, CAMERA.distance]); // moved by hand: it stays so
  }
  near(turnedCamera({ direction: [1, 0, 0], up: [0, 1, 0] }, [0, 0, 2], Math.PI / 2).direction, [0, 1, 0]);
});
