import assert from "node:assert/strict";
import { test } from "node:test";
import { count, counted, decimal, parsed, typed } from "../../../static/viewer/state/numbers.js";

test("numbers show three decimals, three digits that tell something, and an exponent where they are tiny", () => {
  assert.equal(decimal(0), "0.000");
  assert.equal(decimal(0.12345), "0.123");
  assert.equal(decimal(-1.5), "−1.500");
  assert.equal(decimal(0.0123456), "0.0123");
  assert.equal(decimal(0.00123456), "0.00123");
  assert.equal(decimal(0.0005), "5.00e−4");
  assert.equal(decimal(-0.09996), "−0.1000");
  assert.equal(decimal(12345.678), "12,345.678");
  assert.equal(decimal(-999999), "−999,999.000");
  assert.equal(decimal(1234567), "1.23e6");
  assert.equal(decimal(NaN), "–");
  assert.equal(decimal(null), "–");
  assert.equal(decimal(Infinity), "∞");
});

test("what is shown in a box can be typed again and gives the same number back", () => {
  for (const value of [0, -0.25, 3.125, -0.000123, 1.5e9, 1e-12]) {
    const again = /** @type {number} */ (parsed(typed(value)));
    assert.ok(
      Math.abs(again - value) <= Math.max(5e-4, Math.abs(value) * 5e-3),
      `${value} came back as ${again}`,
    );
  }
});

test("typed numbers are read as they are written anywhere, or not at all", () => {
  for (const [text, value] of /** @type {[string, number][]} */ ([
    ["٣٫٥", 3.5], // Arabic
    ["۱۲", 12], // Persian
    ["१.५", 1.5], // Devanagari
    ["１２．５", 12.5], // full width
    ["1\u202f234,5", 1234.5], // French
    ["1'234.5", 1234.5], // Swiss
    ["1,234.5", 1234.5],
    ["1.234,5", 1234.5],
    ["1,234,567", 1234567],
    ["1,234", 1.234],
    ["–2", -2],
    [".5", 0.5],
    ["5.", 5],
    ["+1e3", 1000],
  ]))
    assert.equal(parsed(text), value, text);
  for (const text of ["1,23,456.7", "1.2.3", "12,34,567", "1e", "0x10", "½", "五", "1 2", "--1", "1,2345.6"])
    assert.equal(parsed(text), null, text);
});

test("typed numbers take a comma and a minus sign, and nothing else", () => {
  assert.equal(parsed(" 0,5 "), 0.5);
  assert.equal(parsed("−2"), -2);
  assert.equal(parsed("1e-3"), 0.001);
  for (const text of ["", "abc", "1..2", "Infinity", "NaN"]) assert.equal(parsed(text), null);
});

test("counts stand in groups of three and agree with their noun", () => {
  assert.equal(count(1234567), "1,234,567");
  assert.equal(counted(1, "cell"), "1 cell");
  assert.equal(counted(2000, "vertex", "vertices"), "2,000 vertices");
});
