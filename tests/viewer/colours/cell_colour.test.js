import assert from "node:assert/strict";
import { test } from "node:test";
import { cellColours } from "../../../static/viewer/colours/cell_colour.js";

const COLOUR = { by: "quality", map: "jet", outside: "#000000", inside: "#ff8000", missing: "#010203" };

test("A8 sides are mixed, and values are looked up as the shader does", () => {
  const sides = cellColours({ ...COLOUR, by: "sides" }, null);
  assert.deepEqual([sides(0, 0), sides(0, 1), sides(0, 0.5)], [[0, 0, 0], [255, 128, 0], [128, 64, 0]]); // prettier-ignore
  const positions = Float32Array.of(0, 1, NaN, -0.2, 1.2, -9);
  const clamped = cellColours(COLOUR, { positions, highFirst: false });
  assert.deepEqual(
    [0, 1, 2, 3, 4, 5].map((cell) => clamped(cell, 0)),
    [[0, 0, 127], [141, 0, 0], [1, 2, 3], [0, 0, 127], [141, 0, 0], [1, 2, 3]], // prettier-ignore
  );
  const beyond = { ...COLOUR, beyond: true, below: "#0a0a0a", above: "#f0f0f0" };
  const low = cellColours(beyond, { positions, highFirst: false });
  assert.deepEqual([low(3, 0), low(4, 0), low(0, 0)], [[10, 10, 10], [240, 240, 240], [0, 0, 127]]); // prettier-ignore
  const high = cellColours(beyond, { positions, highFirst: true });
  assert.deepEqual([high(3, 0), high(4, 0)], [[240, 240, 240], [10, 10, 10]]); // prettier-ignore
});

test("A8 categories have their colours", () => {
  const colourOf = cellColours(
    { ...COLOUR, by: "kind" },
    { positions: Float32Array.of(0, 4), highFirst: false },
  );
  assert.deepEqual([colourOf(0, 0), colourOf(1, 0)], [[0xf2, 0xef, 0xe8], [0xc8, 0x37, 0x2d]]); // prettier-ignore
});
