import assert from "node:assert/strict";
import { test } from "node:test";
import {
  clear,
  dig,
  formatCells,
  isClear,
  isolate,
  parseCells,
  undig,
} from "../../../static/viewer/state/picking.js";
import { Numbering, ROWS } from "../../../static/viewer/state/numbering.js";

/** @typedef {import("../../../static/viewer/state/picking.js").Picking} Picking */

test("F4: digging an undug cell and undigging a dug one leave no trace", () => {
  assert.ok(isClear(undig(dig(clear(), 4), 4)));
  assert.ok(isClear(dig(undig(clear(), 4), 4)));
});

test("F4: dug and undug cells are kept apart, in order, once each", () => {
  const picking = [9, 3, 9, 11].reduce((before, cell) => dig(before, cell), /** @type {Picking} */ (clear()));
  assert.deepEqual(picking.hidden, [3, 9, 11]);
  assert.deepEqual(undig(picking, 5).shown, [5]);
  assert.deepEqual(undig(picking, 3).hidden, [9, 11], "an undug cell leaves the list of the dug");
});

test("F4: isolate hides all others; digging the isolated cell hides it too", () => {
  assert.deepEqual(isolate([7, 2, 7]), { enabled: true, isolated: true, hidden: [], shown: [2, 7] });
  assert.deepEqual(dig(isolate([2, 7]), 7).shown, [2]);
  assert.deepEqual(undig(isolate([4]), 6), { enabled: true, isolated: true, hidden: [], shown: [4, 6] });
  const cleared = dig(isolate([4, 6]), 4);
  assert.deepEqual([cleared.isolated, cleared.shown, cleared.hidden], [true, [6], []]);
});

test("F4: cells by number are read back as they were written", () => {
  const cells = [0, 1, 2, 5, 8, 9];
  assert.equal(formatCells(cells, ROWS), "0-2, 5, 8-9");
  assert.deepEqual(parseCells("0-2, 5; 8-9", 10, ROWS), { cells, wrong: "" });
  assert.deepEqual(parseCells(" 9  8-9 ", 10, ROWS).cells, [8, 9]);
});

test("R11: cells are typed by the numbers of their file, with gaps and in any order", () => {
  const own = new Numbering({ first: 1, cells: Int32Array.from([70, 20, 50, 21, 90]) });
  assert.deepEqual(parseCells("70, 20-50", 5, own), { cells: [0, 1, 2, 3], wrong: "" });
  assert.equal(formatCells([3, 1, 0], own), "20-21, 70");
  assert.match(parseCells("60", 5, own).wrong, /“60”: no such cell, they run from 20 to 90/);
  assert.match(parseCells("80-100", 5, own).wrong, /they run from 20 to 90/);
  const counted = new Numbering({ first: 1, cells: null });
  assert.deepEqual(parseCells("1-3", 3, counted).cells, [0, 1, 2]);
  assert.match(parseCells("0", 3, counted).wrong, /they run from 1 to 3/);
  assert.equal(formatCells([0, 1], counted), "1-2");
});

test("R12: groups are chosen as cells are", () => {
  /** @type {import("../../../static/viewer/state/picking.js").Chosen<string>} */
  const none = clear();
  assert.deepEqual(dig(dig(none, "elset:B"), "elset:A").hidden, ["elset:A", "elset:B"]);
  assert.deepEqual(isolate(["b", "a"]).shown, ["a", "b"]);
  assert.ok(isClear(undig(dig(none, "x"), "x")));
});

test("F4: what is no cell is named", () => {
  assert.match(parseCells("3, x", 10, ROWS).wrong, /“x” is not a cell number/);
  assert.match(parseCells("3-10", 10, ROWS).wrong, /“3-10”: no such cell, they run from 0 to 9/);
  assert.match(parseCells("-1", 10, ROWS).wrong, /“-1”/);
});
