import assert from "node:assert/strict";
import { test } from "node:test";
import { nameOfKey } from "../../../static/viewer/input/keys.js";

/** @param {string} key @param {string} code @param {string} [held] c ctrl, a alt, s shift, m meta */
const name = (key, code, held = "") =>
  nameOfKey({
    key,
    code,
    ctrlKey: held.includes("c"),
    altKey: held.includes("a"),
    shiftKey: held.includes("s"),
    metaKey: held.includes("m"),
  });

test("V8 letters of the layout count, not their places", () => {
  assert.equal(name("v", "Period"), "v"); // Dvorak
  assert.equal(name("q", "KeyA"), "q"); // AZERTY
  assert.equal(name("V", "KeyV", "s"), "v");
  assert.equal(name("z", "KeyY", "c"), "Ctrl+z"); // QWERTZ
  assert.equal(name("Z", "KeyZ", "cs"), "Ctrl+Shift+z");
  assert.equal(name("1", "Digit1", "s"), "1"); // AZERTY
  assert.equal(name("ü", "BracketLeft"), "ü");
  assert.equal(name("ArrowUp", "ArrowUp"), "ArrowUp");
});

test("V8 letters and digits of other scripts stand for their place", () => {
  assert.equal(name("м", "KeyV"), "v"); // Russian
  assert.equal(name("я", "KeyZ", "c"), "Ctrl+z");
  assert.equal(name("х", "BracketLeft"), "[");
  assert.equal(name("ω", "KeyV"), "v"); // Greek
  assert.equal(name("ק", "KeyE"), "e"); // Hebrew
  assert.equal(name("١", "Digit1"), "1"); // Arabic
});

test("V8 signs that Option or AltGr makes are signs; with letters both belong to the system", () => {
  assert.equal(name("[", "Digit8", "ca"), "["); // German Windows: AltGr is Ctrl+Alt
  assert.equal(name("[", "Digit5", "a"), "["); // German Mac: Option
  assert.equal(name("]", "Digit9", "ca"), "]");
  assert.equal(name("√", "KeyV", "a"), "");
  assert.equal(name("v", "KeyV", "a"), "");
  assert.equal(name("z", "KeyZ", "ca"), "");
});
