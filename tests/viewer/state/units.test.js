import assert from "node:assert/strict";
import { test } from "node:test";
import { toCsv } from "../../../static/viewer/charts/export.js";
import { Facts } from "../../../static/viewer/state/facts.js";
import { quantityOf } from "../../../static/viewer/state/quantity.js";
import {
  measured,
  plainUnitOf,
  SYMBOLS,
  titled,
  unitOf,
  withUnit,
} from "../../../static/viewer/state/units.js";

const UNITS = /** @type {import("../../../static/viewer/state/units.js").LengthUnit[]} */ (
  Object.keys(SYMBOLS)
);

test("Q1: the unit of a power of a length has its exponent; a number without dimension has none", () => {
  assert.deepEqual(
    [0, 1, 2, 3, 6].map((power) => unitOf({ unit: "mm" }, power)),
    ["", "mm", "mm²", "mm³", "mm⁶"],
  );
  assert.deepEqual(
    UNITS.map((unit) => unitOf({ unit }, 1)),
    ["", "nm", "µm", "mm", "cm", "m", "km", "in", "ft"],
  );
});

test("Q1: in files a unit is told in plain letters", () => {
  assert.deepEqual(
    [0, 1, 2, 3].map((power) => plainUnitOf({ unit: "um" }, power)),
    ["", "um", "um^2", "um^3"],
  );
  for (const unit of UNITS) assert.match(plainUnitOf({ unit }, 3), unit === "none" ? /^$/ : /^[a-z]+\^3$/);
});

test("Q1: where no unit was named everything reads as without", () => {
  const unit = unitOf({ unit: "none" }, 3);
  assert.equal(unit, "");
  assert.equal(plainUnitOf({ unit: "none" }, 3), "");
  assert.equal(measured(1.5, unit), "1.500");
  assert.equal(titled("Volume", unit), "Volume");
  assert.equal(withUnit("1 × 2", unit), "1 × 2");
});

test("Q1: a number and its unit stay in one line; what is no number has none", () => {
  assert.equal(measured(1234.5, "mm³"), "1,234.500\u00a0mm³");
  assert.equal(measured(0, "mm"), "0.000\u00a0mm");
  for (const [value, words] of /** @type {const} */ ([[null, "–"], [NaN, "–"], [-Infinity, "−∞"]])) // prettier-ignore
    assert.equal(measured(value, "mm³"), words);
  assert.equal(titled("Volume", "mm³"), "Volume (mm³)");
});

test("Q1: a metric has the unit of its dimension, an attribute of the file none", () => {
  const row = { symbol: "", variant: "", better: "high", full_range: [0, 1], acceptable_range: null };
  const metrics = [
    { ...row, id: "volume", name: "Volume", length_power: 3 },
    { ...row, id: "shape", name: "Shape", length_power: 0 },
  ];
  const looked = (/** @type {object} */ colour) => {
    const store = { status: { unit: "cm", colour: { by: "quality", attribute: "", ...colour } } };
    return quantityOf(
      /** @type {any} */ ({ store, facts: new Facts(), tables: { metrics, traced: [], compared: [] } }),
    );
  };
  const { unit, lengthPower } = looked({ metric: "volume" });
  assert.deepEqual([unit, lengthPower], ["cm³", 3]);
  assert.equal(looked({ metric: "shape" }).unit, "");
  assert.equal(looked({ metric: "volume", by: "attribute", attribute: "cell:volume" }).unit, "");
});

test("Q4: the head of a histogram's table tells the unit of its edges", () => {
  const data = { edges: [0, 1], counts: [2], map_position: [0], low: 0, high: 1 };
  assert.match(toCsv(data, "volume", "mm^3"), /^volume low \(mm\^3\),volume high \(mm\^3\),cells\r\n0,1,2/);
  assert.match(toCsv(data, "volume"), /^volume low,volume high,cells\r\n/);
});
