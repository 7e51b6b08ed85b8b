import assert from "node:assert/strict";
import { test } from "node:test";
import { Numbering, ROWS } from "../../../static/viewer/state/numbering.js";
import { formatCells, parseCells } from "../../../static/viewer/state/picking.js";

const GAPS = new Numbering({ first: 1, cells: Int32Array.from([40, 10, 12, 11, 7, 2_000_000_000]) });
const FROM_ONE = new Numbering({ first: 1, cells: null });

test("R11: rows have the file's numbers, or are counted on from what the format begins with", () => {
  assert.deepEqual([0, 1, 5].map((row) => GAPS.of(row)), [40, 10, 2_000_000_000]); // prettier-ignore
  assert.equal(FROM_ONE.of(0), 1);
  assert.equal(ROWS.of(3), 3);
});

test("R11: a range finds the rows that have such numbers, in the order of these", () => {
  assert.deepEqual(GAPS.between(10, 12, 6), [1, 3, 2]);
  assert.deepEqual(GAPS.between(41, 1_999_999_999, 6), []);
  assert.deepEqual(GAPS.between(0, 2 ** 31, 6), [4, 1, 3, 2, 0, 5]);
  assert.deepEqual(FROM_ONE.between(0, 2, 5), [0, 1]);
  assert.deepEqual(FROM_ONE.between(5, 9, 5), [4]);
  assert.deepEqual(FROM_ONE.between(6, 9, 5), []);
});

test("R11: numbers that an assembly gives twice find both rows", () => {
  const twice = new Numbering({ first: 1, cells: Int32Array.from([3, 1, 3]) });
  assert.deepEqual(twice.between(3, 3, 3), [0, 2]);
});

test("R11: the ends are the smallest and the largest number", () => {
  assert.deepEqual(GAPS.ends(6), [7, 2_000_000_000]);
  assert.deepEqual(FROM_ONE.ends(5), [1, 5]);
  assert.deepEqual(new Numbering({ first: 1, cells: new Int32Array(0) }).ends(0), [1, 0]);
});

test("R11: numbers past 32 bits, and below 0, are found", () => {
  const wide = new Numbering({ first: 0, cells: Float64Array.from([2 ** 40, -5, 3]) });
  assert.deepEqual(wide.ends(3), [-5, 2 ** 40]);
  assert.deepEqual(wide.between(2 ** 40, 2 ** 41, 3), [0]);
});

test("R11: what is found among many is what a look at each finds", () => {
  let seed = 1;
  const random = (/** @type {number} */ most) => (seed = (seed * 48271) % 2147483647) % most;
  const cells = Int32Array.from({ length: 5000 }, () => random(9000) - 1000);
  const numbering = new Numbering({ first: 0, cells });
  for (let round = 0; round < 50; round++) {
    const low = random(9000) - 1000;
    const high = low + random(300);
    const every = [...cells.keys()].filter((row) => cells[row] >= low && cells[row] <= high);
    const found = numbering.between(low, high, cells.length);
    assert.deepEqual(
      [...found].sort((a, b) => a - b),
      every,
    );
    assert.ok(found.every((row, k) => k === 0 || cells[found[k - 1]] <= cells[row]));
  }
});

test("R11: picked cells are typed and told by the file's numbers", () => {
  assert.deepEqual(parseCells("10-12, 40", 6, GAPS), { cells: [0, 1, 2, 3], wrong: "" });
  assert.equal(formatCells([0, 1, 2, 3], GAPS), "10-12, 40");
  assert.equal(
    parseCells("13", 6, GAPS).wrong,
    "“13”: no such cell, they run from 7 to 2000000000",
    "a number in a gap",
  );
});
