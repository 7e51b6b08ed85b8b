import assert from "node:assert/strict";
import { test } from "node:test";
import { textOf, widestTexts } from "../../../../static/viewer/widgets/table/columns.js";

/** @typedef {import("../../../../static/viewer/widgets/table/columns.js").Column} Column */

/** @param {Partial<Column> & Pick<Column, "values">} some @returns {Column} */
const column = (some) => ({ id: "c", name: "C", kind: "number", ...some });

test("T4: numbers are written as everywhere, or as the column says; words stand for theirs; flags say yes or nothing", () => {
  const numbers = column({ values: [12345, 0.5, NaN] });
  assert.deepEqual([0, 1, 2].map((row) => textOf(numbers, row)), ["12,345", "0.500", "–"]); // prettier-ignore
  assert.equal(textOf({ ...numbers, format: String }, 0), "12345");
  const words = column({ kind: "word", values: Uint8Array.of(1, 0, 7), words: ["plain", "ring"] });
  assert.deepEqual([0, 1, 2].map((row) => textOf(words, row)), ["ring", "plain", ""]); // prettier-ignore
  for (const values of [[true, false], Uint8Array.of(1, 0)]) {
    const flags = column({ kind: "flag", values });
    assert.deepEqual([textOf(flags, 0), textOf(flags, 1)], ["yes", ""]);
  }
});

test("T4: the width of a column is that of its widest value, though only few are looked at", () => {
  const values = new Float64Array(100_000).fill(7);
  values[71_234] = -123456;
  values[50_001] = 99;
  assert.equal(widestTexts(column({ values }), values.length)[0], "-123,456");
  const words = column({ kind: "word", values: [0], words: ["a", "abc", "ab", "abcd", "abcde"] });
  assert.deepEqual(widestTexts(words, 1), ["abcde", "abcd", "abc"]);
  assert.deepEqual(widestTexts(column({ kind: "flag", values: [1] }), 1), []);
  assert.deepEqual(widestTexts(column({ values: [] }), 0), []);
  assert.deepEqual(widestTexts(column({ values: [NaN] }), 1), ["–"]);
});
