import assert from "node:assert/strict";
import { test } from "node:test";
import {
  boundedBy,
  changedKeep,
  keepOf,
  oneSided,
  shareOf,
} from "../../../static/viewer/state/quality_filter.js";

const JACOBIAN = { best: "high", worstValue: 0, bestValue: 1 };
const SKEW = { best: "low", worstValue: 0.8, bestValue: 0 };

test("F3: the left end hides nothing, the right end keeps only the worst value", () => {
  assert.equal(oneSided("scaled_jacobian", "worst", 0, JACOBIAN), null);
  const all = oneSided("scaled_jacobian", "worst", 1, JACOBIAN);
  assert.deepEqual(all, { quantity: "scaled_jacobian", keep: "inside", minimum: null, maximum: 0 });
});

test("F3: where low is best, the worst are those above the bound", () => {
  const half = oneSided("skew", "worst", 0.5, SKEW);
  assert.deepEqual(half, { quantity: "skew", keep: "inside", minimum: 0.4, maximum: null });
  assert.equal(keepOf(half ?? undefined, SKEW), "worst");
});

test("F3: hide the bad is the other end", () => {
  assert.deepEqual(boundedBy("scaled_jacobian", "best", 0.2, JACOBIAN).minimum, 0.2);
  assert.deepEqual(boundedBy("skew", "best", 0.2, SKEW).maximum, 0.2);
});

for (const [name, scale] of Object.entries({ JACOBIAN, SKEW })) {
  for (const keep of /** @type {const} */ (["worst", "best"])) {
    test(`F3: slider and native value agree, ${name} ${keep}`, () => {
      for (const share of [0.1, 0.5, 0.9, 1]) {
        const item = oneSided("m", keep, share, scale) ?? undefined;
        assert.ok(Math.abs(shareOf(item, keep, scale) - share) < 1e-12);
        assert.equal(keepOf(item, scale), keep);
      }
    });
  }
}

test("F3: a band has both ends, inside or outside", () => {
  const band = changedKeep("skew", "band", undefined, SKEW) ?? undefined;
  assert.deepEqual(band, { quantity: "skew", keep: "inside", minimum: 0, maximum: 0.8 });
  assert.equal(keepOf(band, SKEW), "band");
  const hole = changedKeep("skew", "outside", band, SKEW) ?? undefined;
  assert.equal(keepOf(hole, SKEW), "outside");
});
