import assert from "node:assert/strict";
import { test } from "node:test";
import { withSecond } from "../../../static/viewer/charts/second.js";
import { Facts } from "../../../static/viewer/state/facts.js";

/** @param {object} [change] */
const histogram = (change = {}) =>
  /** @type {any} */ ({ quantity: "volume", edges: [0, 1, 2], counts: [4, 4], low: 0, high: 2, ...change });

/** @param {object | null} other */
const besideOf = (other) =>
  withSecond(histogram(), new Facts({ second: new Facts(/** @type {any} */ ({ histogram: other })) })).beside;

test("S6: the histogram of the same quantity stands over that of the first, scaled to as many cells", () => {
  assert.deepEqual(besideOf(histogram({ edges: [0, 2, 4], counts: [1, 3] })), {
    edges: [0, 2, 4],
    counts: [2, 6],
    scaled: true,
  });
  const own = histogram();
  assert.deepEqual({ ...withSecond(own, new Facts()), beside: undefined }, { ...own, beside: undefined });
});

test("S6: none stands there without a second mesh, while its histogram has not come, or is of something else", () => {
  assert.equal(withSecond(histogram(), new Facts()).beside, null);
  assert.equal(besideOf(null), null);
  assert.equal(besideOf(histogram({ quantity: "skew" })), null);
  assert.equal(
    besideOf(histogram({ edges: [0, 0.5, 1, 2], counts: [1, 1, 1] })),
    null,
    "other bins are on their way",
  );
});
