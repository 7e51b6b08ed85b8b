import assert from "node:assert/strict";
import { test } from "node:test";
import { Vector3 } from "three";

import { CameraRig } from "../../../../static/viewer/scene/camera/camera_rig.js";
import { TouchPair } from "../../../../static/viewer/scene/camera/touch_pair.js";
import { Trackball } from "../../../../static/viewer/scene/camera/trackball.js";
import { FRONT } from "./front.js";

/** A trackball on a canvas of 800 x 600 that only has a size. */
function setUp() {
  const rig = new CameraRig(FRONT);
  rig.aspect = 800 / 600;
  const canvas = /** @type {HTMLCanvasElement} */ (
    /** @type {unknown} */ ({
      style: {},
      clientWidth: 800,
      clientHeight: 600,
      hasAttribute: () => false,
      addEventListener() {},
      getBoundingClientRect: () => ({ left: 0, top: 0 }),
    })
  );
  const deaf = { moved() {}, ended() {}, clicked() {}, hovered() {}, centred() {} };
  return { rig, ball: new Trackball(canvas, rig, deaf) };
}

test("V6: what stands under the pointer stays there while the wheel zooms", () => {
  for (const projection of /** @type {const} */ (["perspective", "orthographic"])) {
    const { rig, ball } = setUp();
    rig.set({ projection, direction: [0.2, -0.4, -0.9] });
    const place = rig.pointAt(0.5, 0.25);
    ball.zoomBy(1.8, 600, 225);
    rig.update();
    const now = place.clone().project(rig.camera);
    assert.ok(Math.abs(now.x - 0.5) < 1e-6 && Math.abs(now.y - 0.25) < 1e-6, `${now.toArray()}`);
    assert.ok(Math.abs(rig.distance - FRONT.distance / 1.8) < 1e-9);
  }
});

test("V6: dragging right turns the model's near side right, dragging down brings its top forward", () => {
  const { rig, ball } = setUp();
  ball.turn(400, 300, 440, 300);
  const side = new Vector3(0, 0, 1).applyQuaternion(rig.orientation.clone().invert());
  assert.ok(side.x > 0.05);
  const other = setUp();
  other.ball.turn(400, 300, 400, 340);
  const top = new Vector3(0, 1, 0).applyQuaternion(other.rig.orientation.clone().invert());
  assert.ok(top.z > 0.05);
});

test("V6: turning goes on over the poles: a hundred drags downwards never stop or flip", () => {
  const { rig, ball } = setUp();
  let before = rig.orientation.clone();
  for (let k = 0; k < 100; k++) {
    ball.turn(400, 300, 400, 330);
    const angle = before.angleTo(rig.orientation);
    assert.ok(angle > 0.1 && angle < 0.4, `step ${k}: ${angle}`);
    assert.ok(Math.abs(rig.orientation.length() - 1) < 1e-12);
    before = rig.orientation.clone();
  }
});

test("V6: panning carries the target with the pointer", () => {
  const { rig, ball } = setUp();
  const place = rig.pointAt(0, 0);
  ball.panBy(80, 60);
  rig.update();
  const now = place.project(rig.camera);
  assert.ok(Math.abs(now.x - 0.2) < 1e-6 && Math.abs(now.y + 0.2) < 1e-6, `${now.toArray()}`);
});

test("V6: two fingers pan, spread and turn", () => {
  const pair = new TouchPair();
  assert.equal(pair.add(1, { x: 0, y: 0 }), false);
  assert.equal(pair.move(1, { x: 1, y: 0 }), null);
  assert.equal(pair.add(2, { x: 11, y: 0 }), true);
  const spread = pair.move(2, { x: 21, y: 0 });
  assert.ok(spread);
  assert.deepEqual([spread.scale, spread.dx, spread.dy, Math.abs(spread.roll)], [2, 5, 0, 0]);
  const turned = pair.move(2, { x: 1, y: -20 });
  assert.ok(turned);
  assert.ok(Math.abs(turned.roll - Math.PI / 2) < 1e-12);
  pair.remove(1);
  assert.equal(pair.both, false);
});
