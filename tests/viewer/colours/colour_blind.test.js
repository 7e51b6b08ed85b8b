import assert from "node:assert/strict";
import { test } from "node:test";
import { CATEGORIES } from "../../../static/viewer/colours/palettes.js";
import { VALENCE_STYLES } from "../../../static/viewer/colours/valence.js";
import { apart } from "./colour_blind.js";

/** Far enough in CIELAB to be told apart side by side. */
const ENOUGH = 15;

test("V4: valences, kinds and parts are told apart by eyes that lack a kind of cone", () => {
  const wires = VALENCE_STYLES.colour_blind.map(({ wire }) => wire);
  for (const colours of [wires, CATEGORIES.kind, CATEGORIES.part])
    for (const eyes of /** @type {const} */ (["usual", "deuteranope", "protanope"]))
      colours.forEach((one, k) => {
        for (const other of colours.slice(k + 1))
          assert.ok(apart(one, other, eyes) > ENOUGH, `${one} and ${other} are alike to ${eyes} eyes`);
      });
  const [three, five] = [1, 3].map((row) => VALENCE_STYLES.standard[row].wire);
  assert.ok(apart(three, five, "deuteranope") < apart(three, five, "usual") / 2, "the simulation bites");
});

test("V4: of wires for colour-blind eyes the width tells the valence too", () => {
  const widths = VALENCE_STYLES.colour_blind.map(({ width }) => width);
  assert.deepEqual(
    widths,
    widths.toSorted((a, b) => a - b),
  );
  assert.equal(new Set(widths).size, widths.length);
});
