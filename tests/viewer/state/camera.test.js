import assert from "node:assert/strict";
import { test } from "node:test";
import { cameraOnCell, VIEWS } from "../../../static/viewer/state/camera.js";

test("V6: every named view has a unit direction and a unit up across it", () => {
  for (const [name, { direction, up }] of Object.entries(VIEWS)) {
    const dot = direction.reduce((total, x, axis) => total + x * up[axis], 0);
    assert.ok(Math.abs(dot) < 1e-12, name);
    for (const vector of [direction, up]) assert.ok(Math.abs(Math.hypot(...vector) - 1) < 1e-12, name);
  }
});

test("V7: flying to a cell puts it in the middle, larger the nearer, and keeps the direction", () => {
  /** @type {import("../../../static/viewer/state/camera.js").Camera} */
  const camera = {
    fit: false,
    target: [0, 0, 0],
    direction: [0, 0, -1],
    up: [0, 1, 0],
    distance: 1.5,
    projection: "perspective",
    field_of_view: 30,
  };
  const seen = cameraOnCell(camera, { centre: [0.1, 0.2, 0.3], size: 0.02 });
  assert.deepEqual(seen.target, [0.1, 0.2, 0.3]);
  const share = 0.02 / (2 * seen.distance * Math.tan((15 * Math.PI) / 180));
  assert.ok(share > 0.1 && share < 0.5, `the cell takes ${share} of the height`);
  assert.ok(!("direction" in seen));
});
