import assert from "node:assert/strict";
import { test } from "node:test";
import { decimal } from "../../../static/viewer/state/numbers.js";
import { changedPaths, equal, merge } from "../../../static/viewer/state/paths.js";

test("S1: a key that holds nothing is not the same as another key", () => {
  assert.equal(equal({ a: undefined, b: 1 }, { b: 1, c: 2 }), false);
  assert.equal(equal({ b: 1, c: 2 }, { a: undefined, b: 1 }), false);
  assert.equal(equal({ a: undefined }, {}), false);
  assert.equal(equal({ a: [{ b: 1 }] }, { a: [{ b: 1 }] }), true);
});

test("S1: an item of a list that lost one setting and won another is a change", () => {
  const before = { items: [{ offset: 1, normal: undefined }] };
  const after = { items: [{ offset: 1, rule: "any_corner" }] };
  assert.deepEqual(changedPaths(before, after), ["items"]);
  assert.equal(merge(before, after).items, after.items);
});

test("S1: NaN is itself, 0 is not −0, a list is no object", () => {
  assert.equal(equal([NaN], [NaN]), true);
  assert.equal(equal(0, -0), false);
  assert.equal(equal([], {}), false);
});

test("a million is the first number that is written with an exponent", () => {
  assert.equal(decimal(999999), "999,999.000");
  assert.equal(decimal(1e6), "1.00e6");
  assert.equal(decimal(-1e6), "−1.00e6");
});
