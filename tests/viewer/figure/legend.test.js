import assert from "node:assert/strict";
import { test } from "node:test";
import { legend } from "../../../static/viewer/figure/legend.js";
import { cornersOf, drawWithoutBrowser } from "./drawn.js";

drawWithoutBrowser();

const STYLE = { point: 1, size: 8, ink: "#1d1f23", family: "sans-serif", counts: true };
const BOX = { x: 10, y: 20, width: 120, height: 200 };
const DATA = {
  edges: [0, 1, 2, 3, 4],
  counts: [4, 8, 0, 2],
  map_position: [0, 0.3, 0.6, 1],
  low: 0,
  high: 4,
};

/**
 * What is drawn of the histogram. @param {object | null} beside @param {boolean} upright @param {object} [style]
 */
function drawn(beside, upright, style = {}) {
  const scale = /** @type {any} */ ({
    data: { ...DATA, beside },
    colour: (/** @type {number} */ position) => `rgb(${position})`,
    acceptable: null,
    title: "Volume",
    keys: [],
  });
  const all = /** @type {import("./drawn.js").Drawn[]} */ (
    /** @type {unknown} */ (legend(scale, BOX, { ...STYLE, ...style }, upright))
  );
  const bars = all
    .filter(({ attributes }) => attributes.class === "bar")
    .map(({ attributes: { x, y, width, height } }) => [x, y, width, height].map(Number));
  const lines = all.filter(({ tag, attributes }) => tag === "path" && attributes.fill === "none");
  const texts = all.filter(({ tag }) => tag === "text").map(({ text }) => text);
  return { bars, lines, texts };
}

/** Places along the values and away from them: bars stand to the right of upright values, else above. @param {[number, number][]} corners @param {boolean} upright */
const turned = (corners, upright) =>
  upright ? corners.map(([x, y]) => [-y, x]) : corners.map(([x, y]) => [x, -y]);

for (const upright of [true, false]) {
  const way = upright ? "upright" : "lying";

  test(`S6: a second mesh of the same counts has its line along the ends of the bars, ${way}`, () => {
    const { bars, lines } = drawn({ edges: DATA.edges, counts: DATA.counts }, upright);
    assert.equal(lines.length, 2, "one that is light below it, so that it is seen on any colour");
    assert.equal(lines[0].attributes.d, lines[1].attributes.d);
    assert.deepEqual(
      lines.map(({ attributes }) => attributes.stroke),
      ["#ffffff", STYLE.ink],
    );
    assert.ok(Number(lines[0].attributes["stroke-width"]) > Number(lines[1].attributes["stroke-width"]));
    const corners = turned(cornersOf(lines[1].attributes.d), upright);
    const base = corners[0][1];
    const boxes = bars.map(([x, y, width, height]) => {
      const [a, b] = turned([[x, y], [x + width, y + height]], upright); // prettier-ignore
      return { from: Math.min(a[0], b[0]), to: Math.max(a[0], b[0]), end: Math.max(a[1], b[1]) };
    });
    const filled = [0, 1, 3]; // of the bins
    filled.forEach((bin, k) => {
      const { from, to, end } = boxes[k];
      const [start, stop] = corners.slice(1 + 2 * bin, 3 + 2 * bin);
      for (const [found, expected] of [
        [start[0], from],
        [stop[0], to],
        [start[1], end],
        [stop[1], end],
      ])
        assert.ok(Math.abs(found - expected) < 0.03, `${found} is not ${expected}`); // hundredths are written
    });
    assert.deepEqual(
      corners.slice(5, 7).map(([, away]) => away),
      [base, base],
      "an empty bin has no height",
    );
    assert.equal(corners.at(-1)?.[1], base);
  });

  test(`S6: the axis of counts ends at the largest of both meshes, ${way}`, () => {
    const alone = drawn(null, upright);
    const both = drawn({ edges: DATA.edges, counts: [0, 16, 0, 0] }, upright);
    const length = (/** @type {typeof alone} */ { bars }) =>
      Math.max(...bars.map((bar) => bar[upright ? 2 : 3]));
    assert.ok(alone.texts.includes("8") && !alone.texts.includes("16"));
    assert.ok(both.texts.includes("16"));
    assert.ok(Math.abs(length(both) / length(alone) - 0.5) < 0.02, "bars of 8 are half as long as before");
  });
}

test("S6: without a second mesh no line is drawn", () => {
  assert.equal(drawn(null, true).lines.length, 0);
  assert.equal(drawn({ edges: DATA.edges, counts: DATA.counts }, true, { counts: false }).lines.length, 0);
});

test("S6: a line of other bins stands where its own values are", () => {
  const { lines } = drawn({ edges: [1, 2, 3], counts: [8, 4] }, false);
  const corners = cornersOf(lines[1].attributes.d);
  const { lines: whole } = drawn({ edges: DATA.edges, counts: DATA.counts }, false);
  const all = cornersOf(whole[1].attributes.d);
  const [low, high] = [all[0][0], all[all.length - 1][0]];
  assert.ok(Math.abs(corners[0][0] - (low + (high - low) / 4)) < 0.02);
  assert.ok(Math.abs(corners[corners.length - 1][0] - (low + (3 * (high - low)) / 4)) < 0.02);
});

test("S6: counts that were scaled are told in whole cells", () => {
  const { texts } = drawn({ edges: DATA.edges, counts: [0, 33.3333333, 0, 0] }, true);
  assert.ok(texts.includes("33"), `${texts}`);
  assert.ok(!texts.some((text) => text.startsWith("33.")), `${texts}`);
});
