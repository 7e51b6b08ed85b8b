import assert from "node:assert/strict";
import { test } from "node:test";

import { crowding } from "../../../../static/viewer/scene/layers/irregular_layer.js";

test("V4: wires thin with their number and fade where they are many more than the faces among them", () => {
  assert.deepEqual(crowding(100, 5000), { width: 1, ink: 1 });
  const many = crowding(11_000, 20_000);
  assert.ok(many.width < 0.5 && many.ink === 1, JSON.stringify(many));
  const alone = crowding(11_000, 6);
  assert.ok(alone.ink < 0.1, JSON.stringify(alone));
  for (const [edges, faces] of [
    [1, 0],
    [1e7, 1],
    [0, 0],
  ]) {
    const { width, ink } = crowding(edges, faces);
    assert.ok(width > 0 && width <= 1 && ink > 0 && ink <= 1, `${edges} ${faces} ${width} ${ink}`);
  }
});
