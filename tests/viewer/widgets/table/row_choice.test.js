import assert from "node:assert/strict";
import { test } from "node:test";
import { wayOfClick, wayOfKey } from "../../../../static/viewer/widgets/table/keys.js";
import { placesOf, unsorted } from "../../../../static/viewer/widgets/table/order.js";
import { RowChoice } from "../../../../static/viewer/widgets/table/row_choice.js";

/** @typedef {import("../../../../static/viewer/widgets/table/row_choice.js").Way} Way */

/** @param {Uint32Array} order @param {...[row: number, way: Way]} steps */
function after(order, ...steps) {
  const choice = new RowChoice();
  for (const [row, way] of steps) choice.take(row, way, order, placesOf(order));
  return choice;
}

const PLAIN = unsorted(10);
const MIXED = Uint32Array.of(4, 2, 9, 0, 7, 1, 8, 3, 6, 5);

test("T4: a click chooses one, with Ctrl it is chosen besides, or no longer", () => {
  assert.deepEqual(after(PLAIN, [3, "one"], [5, "one"]).ids, [5]);
  assert.deepEqual(after(PLAIN, [3, "one"], [5, "toggle"], [1, "toggle"]).ids, [3, 5, 1]);
  assert.deepEqual(after(PLAIN, [3, "one"], [5, "toggle"], [3, "toggle"]).ids, [5]);
});

test("T4: a range goes from the last row that was meant, and follows the order of the table", () => {
  assert.deepEqual(after(PLAIN, [3, "one"], [6, "extend"]).ids, [3, 4, 5, 6]);
  assert.deepEqual(after(PLAIN, [3, "one"], [6, "extend"], [1, "extend"]).ids, [1, 2, 3]);
  assert.deepEqual(after(MIXED, [0, "one"], [8, "extend"]).ids, [0, 7, 1, 8]);
  assert.deepEqual(after(MIXED, [5, "one"], [2, "toggle"], [0, "extend"]).ids, [2, 9, 0]);
  assert.deepEqual(after(MIXED, [5, "one"], [2, "toggle"], [0, "add"]).ids, [5, 2, 9, 0]);
  assert.deepEqual(after(PLAIN, [4, "extend"]).ids, [4], "without a row to begin at");
});

test("T4: what is chosen are numbers of rows: sorting changes where they stand, not which they are", () => {
  const choice = after(PLAIN, [3, "one"], [4, "extend"]);
  choice.take(6, "extend", MIXED, placesOf(MIXED));
  assert.deepEqual(choice.ids, [3, 6], "from 3, as it is sorted now");
});

test("T4: the cursor moves without choosing, and a range still begins where it did", () => {
  const choice = after(PLAIN, [3, "one"], [5, "move"]);
  assert.deepEqual(choice.ids, [3]);
  assert.equal(choice.cursor, 5);
  choice.take(6, "extend", PLAIN, placesOf(PLAIN));
  assert.deepEqual(choice.ids, [3, 4, 5, 6]);
});

test("T4: rows chosen from outside are the same ones in any order; none leaves the cursor", () => {
  const choice = after(PLAIN);
  choice.set([7, 2], 7);
  assert.ok(choice.is([2, 7]) && choice.is([2, 7, 7]));
  assert.ok(!choice.is([2]) && !choice.is([2, 8]) && !choice.is([]));
  choice.clear();
  assert.ok(choice.is([]));
  assert.equal(choice.cursor, 7);
});

test("T4: what is held tells how a row is meant", () => {
  const held = (/** @type {string} */ keys) => ({
    ctrlKey: keys.includes("c"),
    metaKey: keys.includes("m"),
    shiftKey: keys.includes("s"),
    altKey: false,
  });
  assert.deepEqual(["", "c", "m", "s", "cs"].map((keys) => wayOfClick(held(keys))), ["one", "toggle", "toggle", "extend", "add"]); // prettier-ignore
  assert.deepEqual(["", "c", "m", "s", "cs"].map((keys) => wayOfKey(held(keys))), ["one", "move", "move", "extend", "extend"]); // prettier-ignore
});
