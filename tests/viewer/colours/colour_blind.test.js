import assert from "node:assert/strict";
import { test } from "node:test";
import { componentsOf } from "../../../static/viewer/colours/components.js";
import { CATEGORIES, NOT_FINITE } from "../../../static/viewer/colours/palettes.js";
import { VALENCE_STYLES } from "../../../static/viewer/colours/valence.js";
import { apart } from "./colour_blind.js";

/** Far enough in CIELAB to be told apart side by side. */
const ENOUGH = 15;

const EYES = /** @type {const} */ (["usual", "deuteranope", "protanope"]);

test("V4: valences, kinds, parts and groups are told apart by eyes that lack a kind of cone", () => {
  const wires = VALENCE_STYLES.colour_blind.map(({ wire }) => wire);
  for (const colours of [wires, CATEGORIES.kind, CATEGORIES.part, CATEGORIES.group])
    for (const eyes of EYES)
      colours.forEach((one, k) => {
        for (const other of colours.slice(k + 1))
          assert.ok(apart(one, other, eyes) > ENOUGH, `${one} and ${other} are alike to ${eyes} eyes`);
      });
  const [three, five] = [1, 3].map((row) => VALENCE_STYLES.standard[row].wire);
  assert.ok(apart(three, five, "deuteranope") < apart(three, five, "usual") / 2, "the simulation bites");
});

test("R12: of groups the first six are further apart, all are light enough for dark lines, and none is the grey of those in none", () => {
  const least = (
    /** @type {readonly string[]} */ colours,
    /** @type {"usual" | "deuteranope" | "protanope"} */ eyes,
  ) => Math.min(...colours.flatMap((one, k) => colours.slice(k + 1).map((other) => apart(one, other, eyes))));
  const found = EYES.map((eyes) => [
    least(CATEGORIES.group.slice(0, 6), eyes),
    least(CATEGORIES.group, eyes),
  ]);
  found.forEach(([six, all], k) => {
    assert.ok(six > 23.5, `the first six are ${six.toFixed(1)} apart to ${EYES[k]} eyes`);
    assert.ok(all > 16.5, `all are ${all.toFixed(1)} apart to ${EYES[k]} eyes`);
  });
  for (const colour of CATEGORIES.group) {
    const lightness = 100 - apart("#ffffff", grey(colour), "usual");
    assert.ok(lightness > 57, `${colour} has a lightness of ${lightness.toFixed(0)}`);
    for (const eyes of EYES)
      assert.ok(apart(colour, NOT_FINITE, eyes) > ENOUGH - 1, `${colour} and the grey of none, ${eyes} eyes`);
  }
});

/** The grey that is as light as a colour. @param {string} hex */
function grey(hex) {
  const [r, g, b] = componentsOf(hex).map((part) =>
    part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4,
  );
  const y = 0.2126729 * r + 0.7151522 * g + 0.072175 * b;
  const byte = Math.round(255 * (y <= 0.0031308 ? 12.92 * y : 1.055 * y ** (1 / 2.4) - 0.055));
  return `#${byte.toString(16).padStart(2, "0").repeat(3)}`;
}

test("V4: of wires for colour-blind eyes the width tells the valence too", () => {
  const widths = VALENCE_STYLES.colour_blind.map(({ width }) => width);
  assert.deepEqual(
    widths,
    widths.toSorted((a, b) => a - b),
  );
  assert.equal(new Set(widths).size, widths.length);
});
