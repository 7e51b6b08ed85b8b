import assert from "node:assert/strict";
import { test } from "node:test";
import { Vector3 } from "three";

import { CameraRig } from "../../../../static/viewer/scene/camera/camera_rig.js";
import { FRONT } from "./front.js";

const PROJECTIONS = /** @type {const} */ (["perspective", "orthographic"]);

const near = (/** @type {readonly number[]} */ a, /** @type {readonly number[]} */ b, tolerance = 1e-9) =>
  a.forEach((value, k) => assert.ok(Math.abs(value - b[k]) < tolerance, `${a} ${b}`));

test("S1: a camera set and read back is the same, and set again changes nothing", () => {
  const rig = new CameraRig(FRONT);
  /** @type {import("../../../../static/viewer/scene/types.js").CameraStatus} */
  const status = {
    fit: false,
    target: [0.1, -0.2, 0.05],
    direction: [-0.48, -0.6, -0.64],
    up: [-0.36, 0.8, -0.48],
    distance: 0.7,
    projection: "orthographic",
    field_of_view: 40,
  };
  assert.equal(rig.set(status), true);
  near(rig.status.direction, status.direction);
  near(rig.status.up, status.up);
  near(rig.status.target, status.target);
  assert.equal(rig.status.distance, 0.7);
  const once = rig.status;
  assert.equal(rig.set(once), false);
  assert.equal(rig.set(rig.status), false);
  assert.deepEqual(rig.status, once);
});

test("V6: looking along up, or nowhere, leaves a camera that stands upright somewhere", () => {
  const rig = new CameraRig(FRONT);
  rig.set({ direction: [0, -1, 0], up: [0, 1, 0] });
  near(rig.status.direction, [0, -1, 0]);
  assert.ok(Math.abs(new Vector3(...rig.status.up).length() - 1) < 1e-9);
  const before = rig.status;
  rig.set({ direction: [0, 0, 0] });
  assert.deepEqual(rig.status, before);
});

test("V6: near and far enclose the scene from outside and from within, in both projections", () => {
  for (const projection of PROJECTIONS) {
    for (const distance of [1.5, 30, 0.6, 0.05, 0.001]) {
      const rig = new CameraRig(FRONT);
      rig.drawn = { low: [-0.5, -0.5, -0.5], high: [0.5, 0.5, 0.5] };
      rig.set({ ...FRONT, distance, projection });
      rig.update();
      const { near: front, far } = rig.camera;
      assert.ok(far > front);
      assert.ok(far >= distance + 0.5, `far ${far} at ${distance}`);
      if (projection === "perspective")
        assert.ok(front > 0 && front <= Math.max(distance - 0.5, distance * 0.01));
      else assert.ok(front <= distance - 0.5);
    }
  }
});

test("V6: the point under a place of the screen projects back to that place", () => {
  for (const projection of PROJECTIONS) {
    const rig = new CameraRig(FRONT);
    rig.aspect = 1.6;
    rig.set({ ...FRONT, direction: [0.3, -0.5, -0.8], projection, target: [0.1, 0, 0] });
    rig.update();
    const place = rig.pointAt(0.3, -0.6).project(rig.camera);
    near([place.x, place.y], [0.3, -0.6], 1e-6);
    const { origin, direction } = rig.rayAt(0.3, -0.6);
    const farther = origin.addScaledVector(direction, 2.7).project(rig.camera);
    near([farther.x, farther.y], [0.3, -0.6], 1e-6);
  }
});
