import assert from "node:assert/strict";
import { test } from "node:test";

import { inWords, vectorOptions } from "../../../static/viewer/state/arrows.js";

/** @param {...[string, number]} rows id and components @returns {any} a summary with these attributes */
const summary = (...rows) => ({
  attributes: rows.map(([id, components]) => ({
    id,
    name: "?",
    on: id.split(":")[0],
    components,
    min: 0,
    max: 1,
  })),
});

test("R8: arrows are offered of attributes of three components, by the names that the file has", () => {
  assert.deepEqual(vectorOptions(null), []);
  assert.deepEqual(vectorOptions(summary(["cell:load", 1], ["cell:stress", 9], ["cell:flow:0", 1])), []);
  assert.deepEqual(vectorOptions(summary(["point:flow", 3], ["point:a:b", 3])), [
    { value: "point:flow", name: "flow" },
    { value: "point:a:b", name: "a:b" },
  ]);
  assert.deepEqual(
    vectorOptions(summary(["cell:flow", 3], ["point:flow", 3])).map(({ name, group }) => [name, group]),
    [
      ["flow", "Of cells"],
      ["flow", "Of points"],
    ],
    "two of one name are told apart",
  );
});

test("R8: it is told how many arrows there are, what the longest is, and which faces have none", () => {
  const told = { drawn: 1000, longest: 71.4142, not_finite: 0, zero: 0 };
  assert.equal(inWords(told), "1,000 arrows; longest vector: 71.414");
  assert.equal(
    inWords({ ...told, drawn: 1, not_finite: 12, zero: 3 }),
    "1 arrow; longest vector: 71.414. Faces without: 12 not finite, 3 zero",
  );
  assert.equal(
    inWords({ drawn: 0, longest: null, not_finite: 6, zero: 0 }),
    "no arrows. Faces without: 6 not finite",
  );
  assert.equal(inWords({ drawn: 0, longest: 0, not_finite: 0, zero: 6 }), "no arrows. Faces without: 6 zero");
  assert.equal(
    inWords({ ...told, drawn: 6, longest: null }),
    "6 arrows",
    "a length beyond what a number holds",
  );
});
