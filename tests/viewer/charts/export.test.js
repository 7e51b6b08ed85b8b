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
  const lines = toCsv(DATA, "skew", "", Int32Array.of(0, 7)).split("\r\n");
  assert.deepEqual(lines, ["skew low,skew high,cells of A,cells of B", "0,0.5,3,0", "0.5,2,4,7", ""]);
});
