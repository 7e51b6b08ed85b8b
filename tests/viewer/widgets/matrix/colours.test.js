import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { componentsOf } from "../../../../static/viewer/colours/components.js";
import { luminance } from "../../../../static/viewer/colours/luminance.js";
import { apart } from "../../colours/colour_blind.js";

const SHEET = readFileSync(new URL("../../../../static/styles/tokens.css", import.meta.url), "utf-8");
const [light, dark] = SHEET.split("prefers-color-scheme: dark");

/** @param {string} scheme @param {string} name */
function token(scheme, name) {
  const found = scheme.match(new RegExp(`--${name}: (#[0-9a-f]{6});`));
  assert.ok(found, `--${name} is a colour`);
  return found[1];
}

for (const [name, scheme] of /** @type {const} */ ([["light", light], ["dark", dark]])) // prettier-ignore
  test(`T4: what pairs do is told apart by all eyes, and from the paper, in the ${name} scheme`, () => {
    const inks = ["crossing", "beside", "crossing-beside"].map((ink) => token(scheme, ink));
    const paper = token(scheme, "surface");
    inks.forEach((ink, k) => {
      const lights = [ink, paper].map((colour) => luminance(componentsOf(colour)) + 0.05);
      assert.ok(Math.max(...lights) / Math.min(...lights) >= 3, `${ink} on ${paper}`);
      for (const other of inks.slice(k + 1))
        for (const eyes of /** @type {const} */ (["usual", "deuteranope", "protanope"]))
          assert.ok(apart(ink, other, eyes) > 25, `${ink}, ${other}: ${apart(ink, other, eyes)} to ${eyes}`);
    });
  });
