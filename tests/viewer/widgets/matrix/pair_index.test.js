import assert from "node:assert/strict";
import { test } from "node:test";
import { outlinedPlaces } from "../../../../static/viewer/widgets/matrix/outlined.js";
import { BESIDE, CROSSES, PairIndex } from "../../../../static/viewer/widgets/matrix/pair_index.js";
import { dense, somePairs } from "./some_pairs.js";

for (const [count, number] of [
  [1, 1],
  [2, 2],
  [17, 40],
  [40, 820],
  [300, 900],
]) {
  // prettier-ignore
  const pairs = somePairs(count, number, count);
  const index = new PairIndex(pairs);
  const all = dense(pairs);

  test(`T4: every place of a matrix of ${count} things tells its pair, on both sides of the diagonal`, () => {
    for (let row = 0; row < count; row++)
      for (let column = 0; column < count; column++) {
        const pair = index.pairAt({ row, column });
        const found = all[row * count + column];
        assert.equal(pair >= 0, found !== 0, `${row}, ${column}`);
        if (pair < 0) continue;
        assert.deepEqual([pairs.one[pair], pairs.other[pair]], [Math.min(row, column), Math.max(row, column)]); // prettier-ignore
        assert.equal(index.kinds[index.cellFrom(row, column)], found);
      }
  });

  test(`T4: the next pair in a row, of ${count} things`, () => {
    for (let row = 0; row < Math.min(count, 20); row++)
      for (let column = 0; column < count; column++)
        for (const step of /** @type {const} */ ([1, -1])) {
          let next = column + step;
          while (next >= 0 && next < count && !all[row * count + next]) next += step;
          const inside = next >= 0 && next < count;
          assert.equal(index.nextInRow({ row, column }, step), inside ? next : column);
        }
  });

  test(`T4: the pair nearest to a place, of ${count} things`, () => {
    for (let k = 0; k < 60; k++) {
      const place = { row: (k * 7) % count, column: (k * 13) % count };
      const reach = k % 6;
      let least = Infinity;
      for (let row = 0; row < count; row++)
        for (let column = 0; column < count; column++)
          if (all[row * count + column])
            least = Math.min(least, Math.max(Math.abs(row - place.row), Math.abs(column - place.column)));
      const found = index.nearest(place, reach);
      if (least > reach) assert.equal(found, null);
      else {
        assert.ok(found && index.pairAt(found) >= 0);
        assert.equal(Math.max(Math.abs(found.row - place.row), Math.abs(found.column - place.column)), least);
      }
    }
  });
}

test("T4: a pair that crosses, runs side by side, or both", () => {
  const pairs = { count: 2, one: [0, 0, 1], other: [0, 1, 1], crossings: [3, 0, 1], beside: [0, 5, 2] };
  const { kinds, starts } = new PairIndex(pairs);
  assert.deepEqual([...kinds], [CROSSES, BESIDE, BESIDE, CROSSES + BESIDE]);
  assert.deepEqual([...starts], [0, 2, 4]);
});

test("T4: no things, and things without pairs", () => {
  assert.deepEqual([...new PairIndex(somePairs(0, 0, 1)).starts], [0]);
  const index = new PairIndex({ count: 3, one: [], other: [], crossings: [], beside: [] });
  assert.equal(index.pairAt({ row: 2, column: 2 }), -1);
  assert.equal(index.nearest({ row: 1, column: 1 }, 5), null);
});

test("T4: one chosen thing is outlined with itself, two with each other, of a few those that meet, of many none", () => {
  const pairs = { count: 20, one: [1, 2], other: [4, 2], crossings: [1, 1], beside: [0, 0] };
  const index = new PairIndex(pairs);
  const places = (/** @type {number[]} */ things) =>
    outlinedPlaces(things, index).map(({ row, column }) => `${row} ${column}`);
  assert.deepEqual(places([]), []);
  assert.deepEqual(places([7]), ["7 7"]);
  assert.deepEqual(places([7, 3]), ["7 3", "3 7"]);
  assert.deepEqual(places([1, 2, 4]), ["1 4", "2 2", "4 1"]);
  assert.deepEqual(places([...Array(20).keys()]), []);
});

test("T4: a million pairs of five thousand things are sorted once, in a moment", () => {
  const pairs = somePairs(5000, 1_000_000, 3);
  const start = performance.now();
  const index = new PairIndex(pairs);
  const took = performance.now() - start;
  assert.ok(index.columns.length > 1_900_000);
  assert.ok(took < 3000, `it took ${took.toFixed(0)} ms`);
});
