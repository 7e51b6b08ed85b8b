import assert from "node:assert/strict";
import { test } from "node:test";
import { Vector3 } from "three";

import { cornersOf } from "../../../../static/viewer/geometry/box.js";
import { CameraRig } from "../../../../static/viewer/scene/camera/camera_rig.js";
import { FILLED } from "../../../../static/viewer/scene/camera/fit.js";
import { FRONT } from "./front.js";

/** @typedef {import("../../../../static/viewer/geometry/box.js").Box} Box */

const PROJECTIONS = /** @type {const} */ (["perspective", "orthographic"]);

/** @type {Record<string, Box>} */
const BODIES = {
  cube: { low: [-0.29, -0.29, -0.29], high: [0.29, 0.29, 0.29] },
  plate: { low: [-0.35, -0.35, -0.01], high: [0.35, 0.35, 0.01] },
  needle: { low: [-0.499, -0.01, -0.01], high: [0.499, 0.01, 0.01] },
  "needle towards the eye": { low: [-0.01, -0.01, -0.499], high: [0.01, 0.01, 0.499] },
  point: { low: [0, 0, 0], high: [0, 0, 0] },
};

/** Places of a box's corners on the screen, -1 to 1 each way. @param {CameraRig} rig @param {Box} box */
function placesOf(rig, { low, high }) {
  rig.update();
  return [0, 1, 2, 3, 4, 5, 6, 7].map((k) =>
    new Vector3(...low.map((end, axis) => ((k >> axis) & 1 ? high[axis] : end))).project(rig.camera),
  );
}

for (const projection of PROJECTIONS)
  for (const aspect of [0.4, 1, 1.5, 3])
    for (const [name, frame] of Object.entries(BODIES))
      test(`V6: a ${name} fits a picture of shape ${aspect} whole, with a margin, ${projection}`, () => {
        const rig = new CameraRig({
          ...FRONT,
          fit: true,
          projection,
          direction: [-0.5, 0.8, -0.4],
          up: [0, 0, 1],
        });
        rig.body = cornersOf(frame);
        rig.drawn = frame;
        rig.aspect = aspect;
        const places = placesOf(rig, frame);
        const reach = Math.max(...places.flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)]));
        assert.ok(reach <= FILLED + 1e-6, `${reach}`);
        for (const { z } of places) assert.ok(z >= -1 && z <= 1, "neither near nor far plane cuts it");
        if (name === "point") return;
        assert.ok(reach > FILLED - 0.02, `it fills one side: ${reach}`);
        for (const side of /** @type {const} */ (["x", "y"])) {
          const ends = places.map((place) => place[side]);
          assert.ok(Math.abs(Math.max(...ends) + Math.min(...ends)) < 0.02, "it stands in the middle");
        }
      });

test("V6: a fitted camera follows the picture's shape; one that was moved stays", () => {
  const rig = new CameraRig({ ...FRONT, fit: true });
  rig.aspect = 2;
  rig.update();
  const wide = rig.distance;
  rig.aspect = 0.5;
  rig.update();
  assert.ok(rig.distance > 1.5 * wide);
  rig.release();
  const tall = rig.distance;
  rig.aspect = 2;
  rig.update();
  assert.equal(rig.distance, tall);
  assert.equal(rig.status.fit, false);
});

test("V6: near and far enclose what is drawn, be it a cell or one that strayed", () => {
  for (const projection of PROJECTIONS) {
    const rig = new CameraRig({ ...FRONT, projection, distance: 2 });
    for (const drawn of [
      { low: [0.1, 0.1, 0.1], high: [0.11, 0.11, 0.11] },
      { low: [-0.3, -0.3, -0.3], high: [0.3, 0.3, 0.3] },
      { low: [-0.3, -0.3, -300], high: [0.3, 0.3, 0.3] },
    ]) {
      rig.drawn = /** @type {Box} */ (drawn);
      for (const { z } of placesOf(rig, rig.drawn)) assert.ok(z >= -1 && z <= 1, `${projection} ${z}`);
    }
    assert.equal(rig.outside, true);
  }
});

test("V6: an eye within what is drawn is not outside", () => {
  const rig = new CameraRig({ ...FRONT, distance: 0.1 });
  assert.equal(rig.outside, false);
});

test("V6: where something covers the right of the picture, a body is fitted into the rest", () => {
  for (const projection of PROJECTIONS) {
    const rig = new CameraRig({ ...FRONT, fit: true, projection });
    rig.body = cornersOf(BODIES.plate);
    rig.drawn = BODIES.plate;
    rig.aspect = 1.5;
    rig.covered = 0.4;
    const xs = placesOf(rig, BODIES.plate).map(({ x }) => x);
    assert.ok(Math.min(...xs) > -1 && Math.max(...xs) < 1 - 2 * 0.4, `${projection} ${xs}`);
    assert.ok(Math.abs(Math.min(...xs) + Math.max(...xs) + 2 * 0.4) < 0.02, "in the middle of the rest");
    const under = rig.pointAt(0.3, -0.2).project(rig.camera);
    assert.ok(Math.abs(under.x - 0.3) < 1e-9 && Math.abs(under.y + 0.2) < 1e-9, "a ray meets its pixel");
  }
});
