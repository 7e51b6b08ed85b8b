import assert from "node:assert/strict";
import { test } from "node:test";
import { changedPaths, difference, merge } from "../../../static/viewer/state/paths.js";

/** A repeatable stream of numbers in [0, 1) (mulberry32). @param {number} seed */
function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** A document of one fixed shape with random leaves. @param {() => number} next */
function documentOf(next) {
  const pick = (/** @type {readonly unknown[]} */ list) => list[Math.floor(next() * list.length)];
  return {
    a: pick([0, 1, null]),
    b: { c: pick(["x", "y"]), d: pick([[], [1], [1, 2]]) },
    e: { f: { g: pick([true, false]) } },
  };
}

test("S1: merging the difference of two documents gives the second, for any two", () => {
  const next = random(7);
  for (let run = 0; run < 300; run++) {
    const [left, right] = [documentOf(next), documentOf(next)];
    assert.deepEqual(merge(left, difference(left, right)), right);
  }
});

test("changedPaths names exactly the leaves in which two documents differ", () => {
  const left = { a: 1, b: { c: [1, 2], d: null }, e: { f: 0 } };
  assert.deepEqual(changedPaths(left, { a: 1, b: { c: [1, 3], d: 4 }, e: { f: 0 } }), ["b.c", "b.d"]);
  assert.deepEqual(changedPaths(left, structuredClone(left)), []);
});

test("null is a value that replaces, undefined is nothing", () => {
  assert.deepEqual(merge({ range: [0, 1] }, { range: null }), { range: null });
  assert.deepEqual(merge({ range: null }, { range: [0, 1] }), { range: [0, 1] });
  assert.deepEqual(merge({ range: 1 }, { range: undefined }), { range: 1 });
});
