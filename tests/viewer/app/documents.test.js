import assert from "node:assert/strict";
import { test } from "node:test";
import { documentText, parse, rejectionsInWords } from "../../../static/viewer/app/documents.js";

test("S2: a status as text reads back the same, whatever its texts hold", () => {
  const status = {
    version: 1,
    mesh: { name: 'a [b]\n"c", {d}.mesh' },
    camera: { direction: [0, 0, -1] },
    filters: { picking: { hidden: [], shown: [1, 2] }, planes: { items: [{ normal: [1, 0, 0] }] } },
  };
  const text = documentText(status);
  assert.deepEqual(JSON.parse(text), status);
  assert.match(text, /"direction": \[0, 0, -1\]/);
});

test("S2: text that is no document is named, with where it came from", () => {
  assert.throws(() => parse("{", "the clipboard"), /the clipboard holds no settings: it is not JSON/);
  assert.throws(() => parse("[1]", "a.txt"), /a.txt holds no settings: found \[1\], expected an object/);
  assert.deepEqual(parse('{"background":"#000000"}', ""), { background: "#000000" });
});

test("S1: wrong values are named by their path, the first three of many", () => {
  const rejection = (/** @type {string} */ path) => ({ path, found: "-1", expected: "at least 0" });
  assert.equal(
    rejectionsInWords([rejection("a.b")]),
    "a.b: found -1, expected at least 0. The rest was applied.",
  );
  assert.match(rejectionsInWords(["a", "b", "c", "d", "e"].map(rejection)), /c: .*; and 2 more\. The rest/);
});
