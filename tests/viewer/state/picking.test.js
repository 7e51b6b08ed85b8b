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

test("F4: digging an undug cell and undigging a dug one leave no trace", () => {
  assert.ok(isClear(undig(dig(clear(), 4), 4)));
  assert.ok(isClear(dig(undig(clear(), 4), 4)));
});

test("F4: dug and undug cells are kept apart, in order, once each", () => {
  const picking = [9, 3, 9, 11].reduce(dig, clear());
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
  assert.equal(formatCells(cells), "0-2, 5, 8-9");
  assert.deepEqual(parseCells("0-2, 5; 8-9", 10), { cells, wrong: "" });
  assert.deepEqual(parseCells(" 9  8-9 ", 10).cells, [8, 9]);
});

test("F4: what is no cell is named", () => {
  assert.match(parseCells("3, x", 10).wrong, /“x” is not a cell number/);
  assert.match(parseCells("3-10", 10).wrong, /“3-10”: cells run from 0 to 9/);
  assert.match(parseCells("-1", 10).wrong, /“-1”/);
});
