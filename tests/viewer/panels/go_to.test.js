import assert from "node:assert/strict";
import { test } from "node:test";
import { parseGoal } from "../../../static/viewer/panels/go_to.js";

const cell = (/** @type {number} */ number) => ({ kind: "cell", number });
const vertex = (/** @type {number} */ number) => ({ kind: "vertex", number });

test("R11: a number is one of a cell or of a node, as is chosen beside it", () => {
  assert.deepEqual(parseGoal("1301", "cell"), cell(1301));
  assert.deepEqual(parseGoal(" 1301 ", "vertex"), vertex(1301));
  assert.deepEqual(parseGoal("#0", "cell"), cell(0));
});

test("R11: a word before the number counts more than what is chosen", () => {
  for (const text of ["node 12", "n12", "N. 12", "Vertex 12", "v #12"])
    assert.deepEqual(parseGoal(text, "cell"), vertex(12), text);
  for (const text of ["element 12", "el 12", "E12", "cell 12", "c12", "el. #12"])
    assert.deepEqual(parseGoal(text, "vertex"), cell(12), text);
});

test("R11: what is no whole number from 0 on is none", () => {
  for (const text of ["", "  ", "node", "12.5", "-3", "1e3", "face 3", "1 2", "1234567890123456", "Infinity"])
    assert.equal(parseGoal(text, "cell"), null, text);
});
