import assert from "node:assert/strict";
import { test } from "node:test";
import { placeByKey } from "../../../../static/viewer/widgets/table/keys.js";
import * as sight from "../../../../static/viewer/widgets/table/sight.js";

const ROW = 28;

/** Ten rows are seen of a hundred thousand. @param {number} top @param {number} [rows] */
const scrolled = (top, rows = 100_000) => ({ top, height: 10 * ROW, row: ROW, rows });

test("T4: only rows in sight are there, and a few beside them", () => {
  for (const top of [0, 13, 28, 5000, 99_990 * ROW, 1e9]) {
    const [first, end] = sight.rowsToDraw(scrolled(top));
    assert.ok(end - first <= 24, `${end - first} rows at ${top}`);
    for (let place = Math.floor(top / ROW); place * ROW < top + 10 * ROW && place < 100_000; place++)
      assert.ok(place >= first && place < end, `${place} is there at ${top}`);
  }
  assert.deepEqual(sight.rowsToDraw(scrolled(0, 3)), [0, 3]);
  assert.deepEqual(sight.rowsToDraw(scrolled(0, 0)), [0, 0]);
  assert.deepEqual(sight.rowsToDraw({ ...scrolled(0), height: 0 }), [0, 0], "while it is hidden");
});

test("T4: a row is brought into sight, no further than is needed", () => {
  assert.equal(sight.topToReach(5, scrolled(0)), 0);
  assert.equal(sight.topToReach(10, scrolled(0)), ROW);
  assert.equal(sight.topToReach(5, scrolled(500 * ROW)), 5 * ROW);
  for (const [place, top] of [[0, 77], [999, 0], [4, 3 * ROW + 1]]) // prettier-ignore
    for (const next of [sight.topToReach(place, scrolled(top)), sight.topToCentre(place, scrolled(top))])
      assert.ok(sight.isInSight(place, scrolled(next)), `${place} from ${top}`);
  assert.ok(!sight.isInSight(0, scrolled(1)) && !sight.isInSight(10, scrolled(0)));
});

/** @param {string} key @param {number | null} place @param {Partial<KeyboardEvent>} [held] @param {number} [rows] */
const led = (key, place, held = {}, rows = 100) =>
  placeByKey(
    { key, ctrlKey: false, metaKey: false, shiftKey: false, altKey: false, ...held },
    place,
    scrolled(20 * ROW, rows),
  );

test("T4: keys lead from row to row and stop at the ends", () => {
  assert.equal(led("ArrowDown", 7), 8);
  assert.equal(led("ArrowUp", 7), 6);
  assert.equal(led("ArrowUp", 0), 0);
  assert.equal(led("ArrowDown", 99), 99);
  assert.equal(led("Home", 50), 0);
  assert.equal(led("End", 50), 99);
  assert.equal(led("PageDown", 50), 59, "the last row that was seen becomes the first");
  assert.equal(led("PageUp", 3), 0);
});

test("T4: without a cursor arrows begin at the first row in sight", () => {
  assert.equal(led("ArrowDown", null), 20);
  assert.equal(led("ArrowUp", null), 20);
  assert.equal(led("End", null), 99);
});

test("T4: other keys, keys with Alt, and keys in an empty table lead nowhere", () => {
  for (const key of ["a", "Tab", "ArrowLeft", "ArrowRight"]) assert.equal(led(key, 3), null, key);
  assert.equal(led("ArrowDown", 3, { altKey: true }), null);
  assert.equal(led("Home", null, {}, 0), null);
});
