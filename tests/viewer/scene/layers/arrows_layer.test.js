import assert from "node:assert/strict";
import { test } from "node:test";

import { ArrowsLayer } from "../../../../static/viewer/scene/layers/arrows_layer.js";

const VIEW = { pixel: 0.002, pixelRatio: 1 };
const CHOSEN = { attribute: "point:flow", length: 0.1, colour: "#1d1f23" };

/** @param {number} count */
const record = (count) => ({
  positions: Float32Array.from({ length: 3 * count }, (_, k) => 0.25 * (k % 3)),
  vectors: new Float32Array(3 * count).fill(0.5),
  inward: new Uint8Array(count),
  cells: new Uint32Array(count),
  longest: 1,
  not_finite: 0,
  zero: 0,
});

test("R8: arrows are drawn where some were chosen and there are any", () => {
  const layer = new ArrowsLayer();
  layer.set(record(2));
  assert.equal(layer.group.visible, false, "none is chosen");
  assert.equal(layer.box, null);
  layer.look(CHOSEN);
  assert.equal(layer.group.visible, true);
  layer.set(record(0));
  assert.equal(layer.group.visible, false);
  layer.set(record(2));
  layer.look({ attribute: "" });
  assert.equal(layer.group.visible, false);
});

test("R8: what is drawn lies within the box, however long the arrows are", () => {
  const layer = new ArrowsLayer();
  layer.set(record(2));
  layer.look(CHOSEN);
  const near = (/** @type {readonly number[] | undefined} */ found, /** @type {number[]} */ expected) =>
    expected.every((part, k) => Math.abs(part - (found?.[k] ?? NaN)) < 1e-6);
  assert.ok(near(layer.box?.low, [-0.1, 0.15, 0.4]) && near(layer.box?.high, [0.1, 0.35, 0.6]));
  layer.look({ length: 0.5 });
  assert.ok(near(layer.box?.low, [-0.5, -0.25, 0]));
});

test("P2: arrows of an older surface are left out of drafts, until a whole picture tells that they still hold", () => {
  const layer = new ArrowsLayer();
  layer.look(CHOSEN);
  layer.set(record(2));
  layer.view({ ...VIEW, draft: true });
  assert.equal(layer.group.visible, true, "a draft of a turning model has them");
  layer.stale = true; // a lean surface came
  layer.view({ ...VIEW, draft: true });
  assert.equal(layer.group.visible, false);
  layer.view({ ...VIEW, draft: false });
  layer.view({ ...VIEW, draft: true });
  assert.equal(layer.group.visible, true);
  layer.stale = true;
  layer.set(record(3));
  layer.view({ ...VIEW, draft: true });
  assert.equal(layer.group.visible, true, "they came with the surface");
});

test("R8: arrows stand out from what they lie on by a rim, light around dark ink and dark around light", () => {
  const layer = new ArrowsLayer();
  const inks = () =>
    layer.group.children.map((mesh) =>
      /** @type {any} */ (mesh).material.uniforms.ink.value
        .toArray()
        .map((/** @type {number} */ part) => Math.round(255 * part)),
    );
  layer.look({ colour: "#204080" });
  assert.deepEqual(inks(), [[255, 255, 255], [32, 64, 128], [255, 255, 255]]); // prettier-ignore
  layer.look({ colour: "#ffff00" });
  assert.deepEqual(inks()[1], [255, 255, 0]);
  assert.ok(inks()[0].every((/** @type {number} */ part) => part < 60));
});
