import assert from "node:assert/strict";
import { test } from "node:test";
import { toCsv } from "../../../static/viewer/charts/export.js";

const DATA = { edges: [0, 0.5, 2], counts: [3, 4], map_position: [0, 1], low: 0, high: 2 };

test("Q4: a row for each bin, under a head that names what was measured", () => {
  assert.equal(
    toCsv(DATA, "volume", "mm^3"),
    "volume low (mm^3),volume high (mm^3),cells\r\n0,0.5,3\r\n0.5,2,4\r\n",
  );
  assert.equal(toCsv(DATA, 'a,"b"').split("\r\n")[0], "a  b  low,a  b  high,cells");
});

test("S6: cells of a second mesh have a column of their own, and each column says whose it is", () => {
  const lines = toCsv(DATA, "skew", "", { edges: Float64Array.of(0, 0.5, 2), counts: Int32Array.of(0, 7) });
  assert.deepEqual(lines.split("\r\n"), [
    "skew low,skew high,cells of A,cells of B",
    "0,0.5,3,0",
    "0.5,2,4,7",
    "",
  ]);
});

test("S6: where each mesh has a range of its own, the second one's counts have its own bins beside them", () => {
  const lines = toCsv(DATA, "volume", "mm^3", { edges: [0, 1, 3], counts: [5, 6] }).split("\r\n");
  assert.deepEqual(lines, [
    "volume low (mm^3) of A,volume high (mm^3) of A,cells of A,volume low (mm^3) of B,volume high (mm^3) of B,cells of B",
    "0,0.5,3,0,1,5",
    "0.5,2,4,1,3,6",
    "",
  ]);
});
