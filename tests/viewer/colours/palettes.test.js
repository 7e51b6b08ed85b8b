import assert from "node:assert/strict";
import { test } from "node:test";

import {
  mapColours,
  PALETTES,
  paletteBytes,
  paletteColour,
} from "../../../static/viewer/colours/palettes.js";

const hex = (/** @type {string} */ map, /** @type {number} */ t) =>
  `#${paletteColour(map, t)
    .map((c) =>
      Math.round(255 * c)
        .toString(16)
        .padStart(2, "0"),
    )
    .join("")}`;

test("Q5: the maps begin with the best colour and end with the worst", () => {
  assert.deepEqual([...PALETTES].sort(), ["diverging", "jet", "parula", "red_blue", "viridis"]);
  assert.deepEqual([hex("parula", 0), hex("parula", 1)], ["#352a87", "#f9fb0e"]);
  assert.deepEqual([hex("jet", 0), hex("jet", 1)], ["#00007f", "#8d0000"]);
  assert.deepEqual(
    [hex("red_blue", 0), hex("red_blue", 0.5), hex("red_blue", 1)],
    ["#0000ff", "#ffffff", "#ff0000"],
  );
  assert.deepEqual([hex("viridis", 0), hex("viridis", 1)], ["#440154", "#fde725"]);
  assert.deepEqual(
    [hex("diverging", 0), hex("diverging", 0.5), hex("diverging", 1)],
    ["#1f5fa8", "#f4f2ee", "#b01f2e"],
  );
});

test("Q5: parula and viridis grow lighter all the way, by the eye's measure", () => {
  const lightness = (/** @type {readonly number[]} */ [r, g, b]) => {
    const [x, y, z] = [r, g, b].map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4));
    return 116 * Math.cbrt(0.2126 * x + 0.7152 * y + 0.0722 * z) - 16;
  };
  const last = { parula: -1, viridis: -1 };
  for (let k = 0; k <= 64; k++) {
    for (const map of /** @type {const} */ (["parula", "viridis"])) {
      const now = lightness(paletteColour(map, k / 64));
      assert.ok(now > last[map] - 0.3, `${map} at ${k}/64`);
      last[map] = now;
    }
  }
});

test("Q5: no map jumps between neighbouring entries; places outside are those at the ends", () => {
  for (const map of PALETTES) {
    const bytes = paletteBytes(map);
    for (let k = 4; k < bytes.length; k++)
      assert.ok(Math.abs(bytes[k] - bytes[k - 4]) <= 8, `${map} ${k >> 2}`);
    assert.deepEqual(paletteColour(map, -1), paletteColour(map, 0));
    assert.deepEqual(paletteColour(map, 2), paletteColour(map, 1));
  }
});

test("V3: a map can be turned round, run in steps, and have a colour for what has no value", () => {
  const plain = mapColours({ map: "red_blue" });
  const turned = mapColours({ map: "red_blue", reversed: true });
  assert.equal(plain(0), "#0000ff");
  assert.equal(turned(0), "#ff0000");
  assert.equal(turned(1), plain(0));
  const stepped = mapColours({ map: "red_blue", steps: 3 });
  assert.deepEqual([0, 0.3, 0.34, 0.6, 0.7, 1].map(stepped), [
    "#0000ff", "#0000ff", "#ffffff", "#ffffff", "#ff0000", "#ff0000",
  ]); // prettier-ignore
  assert.equal(mapColours({ map: "jet", missing: "#123456" })(NaN), "#123456");
  const ends = { map: "jet", beyond: true, above: "#111111", below: "#222222" };
  assert.deepEqual([-0.1, 1.1].map(mapColours(ends, true)), ["#111111", "#222222"]);
  assert.deepEqual([-0.1, 1.1].map(mapColours(ends)), ["#222222", "#111111"]);
  assert.equal(mapColours({ ...ends, beyond: false })(-0.1), mapColours(ends)(0));
  const bytes = paletteBytes("red_blue", { steps: 2, reversed: true });
  assert.deepEqual([...bytes.subarray(0, 3)], [255, 0, 0]);
  assert.deepEqual([...bytes.subarray(4 * 255, 4 * 255 + 3)], [0, 0, 255]);
  assert.equal(
    new Set(Array.from({ length: 256 }, (_, k) => bytes.subarray(4 * k, 4 * k + 3).join())).size,
    2,
  );
});
