import assert from "node:assert/strict";
import { test } from "node:test";
import { beside, corners } from "../../../static/viewer/charts/steps.js";
import { random } from "../widgets/random.js";

const EDGES = [0, 1, 2, 3];

test("S6: counts of a mesh of as many cells stay what they are", () => {
  const other = beside({ edges: EDGES, counts: [1, 2, 3] }, { edges: [5, 6, 7, 8], counts: [0, 6, 0] });
  assert.deepEqual(other, { edges: [5, 6, 7, 8], counts: [0, 6, 0], scaled: false });
});

test("S6: counts of a mesh of another number of cells are as if it had as many", () => {
  const other = beside(
    { edges: EDGES, counts: [10, 20, 10] },
    { edges: EDGES, counts: Int32Array.of(4, 0, 6) },
  );
  assert.deepEqual(other, { edges: EDGES, counts: [16, 0, 24], scaled: true });
  const next = random(2);
  const some = () => Array.from({ length: 50 }, () => Math.floor(1000 * next()));
  const sum = (/** @type {number[]} */ list) => list.reduce((all, one) => all + one, 0);
  for (let round = 0; round < 20; round++) {
    const [ours, theirs] = [some(), some()];
    const { counts } = beside({ edges: [], counts: ours }, { edges: [], counts: theirs });
    assert.ok(Math.abs(sum(counts) - sum(ours)) < 1e-9 * sum(ours));
    const [k, l] = [3, 17]; // and their shares are those of its own cells
    assert.ok(Math.abs(counts[k] * theirs[l] - counts[l] * theirs[k]) < 1e-6 * (1 + counts[k] * theirs[l]));
  }
});

test("S6: a mesh without a finite value has no counts that could be scaled", () => {
  assert.deepEqual(
    beside({ edges: EDGES, counts: [1, 1, 1] }, { edges: EDGES, counts: [0, 0, 0] }).counts,
    [0, 0, 0],
  );
});

test("S6: the outline goes up and down at every edge, and begins and ends at the axis", () => {
  const found = corners({ edges: EDGES, counts: [2, 0, 4] }, { low: 0, high: 3 }, (count) => count / 4);
  assert.deepEqual(found, [[0, 0], [0, 0.5], [1, 0.5], [1, 0], [2, 0], [2, 1], [3, 1], [3, 0]]); // prettier-ignore
});

test("S6: the outline's area is that of the bars", () => {
  const next = random(9);
  const counts = Array.from({ length: 12 }, () => Math.floor(100 * next()));
  const edges = Array.from({ length: 13 }, (_, k) => k * k);
  const found = corners({ edges, counts }, { low: 0, high: 144 }, (count) => count / 100);
  let area = 0;
  for (let k = 1; k < found.length; k++)
    area += ((found[k][0] - found[k - 1][0]) * (found[k][1] + found[k - 1][1])) / 2;
  const expected = counts.reduce((sum, count, bin) => sum + (count / 100) * (edges[bin + 1] - edges[bin]), 0);
  assert.ok(Math.abs(area - expected) < 1e-9);
});

test("S6: bins beyond the axis are cut off at its ends, and counts beyond it at the top", () => {
  const found = corners(
    { edges: [-2, -1, 1, 4], counts: [1, 2, 9] },
    { low: 0, high: 2 },
    (count) => count / 3,
  );
  for (const [value, share] of found) {
    assert.ok(value >= 0 && value <= 2, `${value}`);
    assert.ok(share >= 0 && share <= 1, `${share}`);
  }
  assert.deepEqual(found.at(0), [0, 0]);
  assert.deepEqual(found.at(-1), [2, 0]);
  assert.deepEqual(found.slice(3, 7), [[0, 2 / 3], [1, 2 / 3], [1, 1], [2, 1]]); // prettier-ignore
});
