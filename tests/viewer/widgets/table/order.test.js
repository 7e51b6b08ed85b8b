import assert from "node:assert/strict";
import { test } from "node:test";
import { placesOf, sorted, unsorted } from "../../../../static/viewer/widgets/table/order.js";
import { random } from "../random.js";

/** @param {ArrayLike<number | boolean>} values @param {readonly string[]} [words] */
const column = (values, words) =>
  /** @type {import("../../../../static/viewer/widgets/table/columns.js").Column} */ ({
    id: "c",
    name: "C",
    kind: words ? "word" : "number",
    values,
    words,
  });

/** @param {ArrayLike<number | boolean>} values @param {boolean} descending @param {readonly string[]} [words] */
const order = (values, descending, words) => [
  ...sorted(unsorted(values.length), column(values, words), descending),
];

test("T4: rows are sorted by numbers, up and down; those that are equal stay as they were", () => {
  const next = random(5);
  const values = Array.from({ length: 500 }, () => Math.floor(next() * 20) - 10);
  for (const descending of [false, true]) {
    const rows = order(values, descending);
    assert.deepEqual(
      rows.toSorted((a, b) => a - b),
      [...values.keys()],
    );
    rows.slice(1).forEach((row, k) => {
      const step = (values[row] - values[rows[k]]) * (descending ? -1 : 1);
      assert.ok(step > 0 || (step === 0 && row > rows[k]), `${rows[k]} stands before ${row}`);
    });
  }
});

test("T4: columns are sorted by one after the other", () => {
  const [kind, size] = [
    [1, 0, 1, 0],
    [7, 9, 3, 2],
  ];
  const bySize = sorted(unsorted(4), column(size), false);
  assert.deepEqual([...sorted(bySize, column(kind), false)], [3, 1, 2, 0]);
  assert.deepEqual([...sorted(bySize, column(kind), true)], [2, 0, 3, 1]);
});

test("T4: what is no number comes last, whichever way; infinities have their place", () => {
  const values = [2, NaN, -Infinity, 1, Infinity, NaN];
  assert.deepEqual(order(values, false), [2, 3, 0, 4, 1, 5]);
  assert.deepEqual(order(values, true), [4, 0, 3, 2, 1, 5]);
});

test("T4: words stand as in a dictionary, numbers in them by size, whatever their places in the list", () => {
  const words = ["plain", "i 5 5", "i 10", "Box", "i 5 3"];
  assert.deepEqual(order([0, 1, 2, 3, 4, 0], false, words), [3, 4, 1, 2, 0, 5]);
  assert.deepEqual(
    order([0, 1, 2, 3, 4, 9], true, words),
    [0, 2, 1, 4, 3, 5],
    "a word that is not there: last",
  );
});

test("T4: flags: those that hold come last, or first", () => {
  assert.deepEqual(order([true, false, true, false], false), [1, 3, 0, 2]);
  assert.deepEqual(order(Uint8Array.of(1, 0, 1, 0), true), [0, 2, 1, 3]);
});

test("T4: places undo an order", () => {
  const rows = sorted(unsorted(6), column([3, 1, 2, 3, 0, 1]), true);
  const places = placesOf(rows);
  rows.forEach((row, place) => assert.equal(places[row], place));
  assert.equal(placesOf(unsorted(0)).length, 0);
});

test("T4: a hundred thousand rows are sorted without being felt", () => {
  const next = random(11);
  const values = Float64Array.from({ length: 100_000 }, next);
  const start = performance.now();
  const rows = sorted(unsorted(values.length), column(values), false);
  const took = performance.now() - start;
  assert.ok(values[rows[0]] <= values[rows[99_999]]);
  assert.ok(took < 1000, `it took ${took.toFixed(0)} ms`);
});
