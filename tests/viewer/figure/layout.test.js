import assert from "node:assert/strict";
import { test } from "node:test";

import { cutTo } from "../../../static/viewer/figure/cut.js";
import { layOut, wrapped } from "../../../static/viewer/figure/layout.js";
import { roundLength } from "../../../static/viewer/figure/overlay.js";
import { readableTicks } from "../../../static/viewer/figure/ticks.js";
import { keysOf } from "../../../static/viewer/figure/keys.js";
import { PANELS, panelsOf } from "../../../static/viewer/state/panels.js";

/** @type {import("../../../static/viewer/figure/layout.js").Asked} */
const PLAIN = {
  width: 1000,
  height: 600,
  point: 4,
  letters: 8,
  margin: 0,
  panels: 1,
  lettered: false,
  legend: "none",
  legendPlace: "right",
  lines: 0,
};

test("S5: a figure without anything around is its picture, pixel by pixel", () => {
  const { pictures, legend, caption } = layOut(PLAIN);
  assert.deepEqual(pictures, [{ x: 0, y: 0, width: 1000, height: 600 }]);
  assert.equal(legend, null);
  assert.equal(caption, null);
});

test("S5: pictures, legend and caption stand beside each other within the margins", () => {
  for (const legendPlace of /** @type {const} */ (["left", "right"]))
    for (const panels of [1, 2, 6]) {
      const asked = /** @type {const} */ ({
        ...PLAIN,
        margin: 5,
        panels,
        lettered: panels > 1,
        legend: "bar",
        legendPlace,
        lines: 2,
      });
      const { pictures, legend, caption } = layOut(asked);
      assert.equal(pictures.length, panels);
      assert.ok(legend && caption);
      for (const { x, y, width, height } of [...pictures, legend, caption]) {
        assert.ok(
          x >= 20 && y >= 20 && x + width <= 980.5 && y + height <= 580.5,
          JSON.stringify({ x, y, width, height }),
        );
        assert.ok(width > 0 && height > 0);
      }
      for (const [k, box] of pictures.entries()) {
        assert.ok(box.y + box.height <= caption.y);
        const [left, right] = legendPlace === "left" ? [legend, box] : [box, legend];
        assert.ok(left.x + left.width <= right.x);
        if (k) assert.ok(pictures[k - 1].x + pictures[k - 1].width < box.x);
        assert.ok(Math.abs(box.width - pictures[0].width) <= 1);
      }
    }
});

test("S5: a figure too small for what stands around is refused in words", () => {
  assert.throws(() => layOut({ ...PLAIN, width: 120, legend: "histogram" }), /leaves no room/);
});

test("S5: a caption is wrapped at words", () => {
  const measure = (/** @type {string} */ text) => text.length;
  assert.deepEqual(wrapped("one two  three four", 9, measure), ["one two", "three", "four"]);
  assert.deepEqual(wrapped("averyverylongword is", 5, measure), ["averyverylongword", "is"]);
  assert.deepEqual(wrapped("", 5, measure), []);
});

test("S5: a scale bar has a round length", () => {
  for (const [longest, length] of [
    [1, 1],
    [0.99, 0.5],
    [7, 5],
    [0.0231, 0.02],
    [4999, 2000],
    [5000, 5000],
  ])
    assert.ok(Math.abs(roundLength(longest) - length) < 1e-9 * length, `${longest} ${roundLength(longest)}`);
});

test("Q4: an axis has both ends labelled, and no label over another", () => {
  for (const [low, high] of [
    [0, 1],
    [-0.37, 4.2],
    [3, 3],
    [0, 439_348],
    [1e-9, 2e-9],
  ])
    for (const length of [20, 100, 400]) {
      const ticks = readableTicks(low, high, length, 30);
      assert.equal(ticks[0], low);
      assert.equal(ticks.at(-1), high);
      const places = ticks.map((value) => (high > low ? ((value - low) / (high - low)) * length : 0));
      for (let k = 1; k < places.length; k++)
        assert.ok(places[k] - places[k - 1] >= 30 || ticks.length === 2, `${ticks}`);
    }
});

test("S5: what is cropped fills its box one way, and is not larger than it can be drawn", () => {
  const box = { x: 0, y: 0, width: 800, height: 600 };
  const { whole, part } = cutTo({ left: 0.25, top: 0.4, right: 0.75, bottom: 0.6 }, box);
  assert.equal(part.width, 800);
  assert.ok(Math.abs(part.height - 240) <= 1);
  assert.ok(Math.abs(whole.width / whole.height - 800 / 600) < 0.01);
  const tiny = cutTo({ left: 0.5, top: 0.5, right: 0.501, bottom: 0.501 }, box);
  assert.ok(Math.max(tiny.whole.width, tiny.whole.height) <= 8192);
});

test("S5: panels differ by the setting that was chosen alone", () => {
  const modes = /** @type {import("../../../static/viewer/state/tables.js").Tables["choices"]} */ (
    /** @type {unknown} */ ({
      "separation.mode": ["lines", "darkness_coded_edges", "fissure", "rounded"],
      "lighting.mode": ["object_space_ao", "screen_space_ao", "direct", "none"],
    })
  );
  const status = (/** @type {object} */ panels) =>
    /** @type {import("../../../static/viewer/state/status.js").Status} */ (
      /** @type {unknown} */ ({
        figure: { panels },
        filters: { planes: { items: [{ enabled: false, normal: [0, 1, 0], offset: 0 }] } },
      })
    );
  assert.deepEqual(panelsOf(status({ setting: "none", values: [1, 2] }), modes), [{}]);
  assert.deepEqual(panelsOf(status({ setting: "peel", values: [0, 2] }), modes), [
    { filters: { peel: { enabled: true, depth: 0 } } },
    { filters: { peel: { enabled: true, depth: 2 } } },
  ]);
  assert.deepEqual(panelsOf(status({ setting: "separation", values: [0, 9] }), modes)[1], {
    separation: { mode: "rounded" },
  });
  assert.deepEqual(panelsOf(status({ setting: "lighting", values: [3, 2] }), modes)[0], {
    lighting: { mode: "none" },
  });
  const [, sliced] = panelsOf(status({ setting: "slice", values: [0, 0.5] }), modes);
  assert.deepEqual(sliced.filters?.planes?.items, [{ enabled: true, normal: [0, 1, 0], offset: 0.5 }]);
  for (const { values } of Object.values(PANELS)) assert.ok(values.length >= 2 && values.length <= 6);
});

test("S5: colours that are on no map are named where there are such cells", () => {
  const colour = /** @type {Parameters<typeof keysOf>[1]} */ ({
    range: [0.2, 0.9],
    beyond: true,
    above: "#d6409f",
    below: "#3c3c3c",
    missing: "#8c8c8c",
  });
  const data = { counts: [3, 1, 4], map_position: [1.2, 0.5, -0.1], not_finite: 2 };
  const names = (/** @type {object} */ change, highFirst = true) =>
    keysOf({ ...data, ...change }, colour, highFirst).map(({ name }) => name);
  assert.deepEqual(names({}), ["above 0.9", "below 0.2", "not finite"]);
  assert.deepEqual(names({ counts: [3, 1, 0], not_finite: 0 }), ["below 0.2"]);
  assert.deepEqual(names({ counts: [3, 1, 0], not_finite: 0 }, false), ["above 0.9"]);
  assert.deepEqual(
    keysOf(data, { ...colour, beyond: false }, true).map((key) => key.colour),
    ["#8c8c8c"],
  );
});
