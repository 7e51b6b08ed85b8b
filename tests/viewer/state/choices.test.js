import assert from "node:assert/strict";
import { test } from "node:test";
import { optionsOf, rangeOf } from "../../../static/viewer/state/choices.js";

const tables = /** @type {import("../../../static/viewer/state/tables.js").Tables} */ (
  /** @type {unknown} */ ({
    choices: { "separation.mode": ["rounded", "lines"] },
    limits: { "histogram.bins": [1, 1000] },
  })
);

test("S1: options are the words that the schema has, in its order, by their names on the screen", () => {
  assert.deepEqual(optionsOf("separation.mode")({ tables }), [
    { value: "rounded", name: "Rounded" },
    { value: "lines", name: "Lines" },
  ]);
});

test("S1: a slider runs between the limits that the schema has", () => {
  assert.deepEqual(rangeOf("histogram.bins", 10)({ tables }), [1, 1000, 10]);
});
