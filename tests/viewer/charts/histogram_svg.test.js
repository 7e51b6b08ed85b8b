import assert from "node:assert/strict";
import { test } from "node:test";
import { layOut } from "../../../static/viewer/charts/histogram_layout.js";
import { marks } from "../../../static/viewer/charts/histogram_svg.js";
import { cornersOf, drawWithoutBrowser } from "../figure/drawn.js";

drawWithoutBrowser();

const DATA = { edges: [0, 1, 3], counts: [6, 3], map_position: [0, 1], low: 0, high: 3 };

const LOOK = {
  colour: () => "#123456",
  ink: "#111111",
  paper: "#eeeeee",
  quiet: "#777777",
  line: "#cccccc",
  rim: "none",
  acceptable: null,
};

/** @param {"horizontal" | "vertical"} orientation @param {{ edges: number[], counts: number[] } | null} beside */
function drawn(orientation, beside) {
  const layout = layOut({ ...DATA, beside }, { width: 300, height: 150, orientation, scale: "linear" });
  const all = /** @type {import("../figure/drawn.js").Drawn[]} */ (
    /** @type {unknown} */ (marks(layout, DATA, LOOK))
  );
  const lines = all.filter(({ tag, attributes }) => tag === "path" && attributes.fill === "none");
  return { plot: layout.plot, lines, texts: all.filter(({ tag }) => tag === "text").map(({ text }) => text) };
}

test("S6: a second mesh's counts are a line with a light rim, from the axis up and back to it", () => {
  const { plot, lines } = drawn("horizontal", { edges: [0, 1, 3], counts: [3, 6] });
  assert.deepEqual(lines.map(({ attributes }) => attributes.stroke), [LOOK.paper, LOOK.ink]); // prettier-ignore
  const { x, y, width, height } = plot;
  const [base, half, third] = [y + height, y + height / 2, x + width / 3];
  const expected = [[x, base], [x, half], [third, half], [third, y], [x + width, y], [x + width, base]]; // prettier-ignore
  cornersOf(lines[1].attributes.d).forEach((corner, k) =>
    corner.forEach((place, axis) => assert.ok(Math.abs(place - expected[k][axis]) < 0.01, `${k}`)),
  );
});

test("S6: of a histogram that stands up the line runs along the values upwards", () => {
  const { plot, lines } = drawn("vertical", { edges: [0, 1, 3], counts: [3, 6] });
  const { x, y, width, height } = plot;
  const third = y + (2 * height) / 3;
  const expected = [
    [x, y + height],
    [x + width / 2, y + height],
    [x + width / 2, third],
    [x + width, third],
    [x + width, y],
    [x, y],
  ];
  cornersOf(lines[1].attributes.d).forEach((corner, k) =>
    corner.forEach((place, axis) => assert.ok(Math.abs(place - expected[k][axis]) < 0.01, `${k}`)),
  );
});

test("S6: without a second mesh there is no line, and the largest count is told in whole cells", () => {
  assert.equal(drawn("horizontal", null).lines.length, 0);
  assert.ok(drawn("horizontal", null).texts.includes("6"));
  assert.ok(drawn("horizontal", { edges: [0, 1, 3], counts: [1.25, 7.75] }).texts.includes("8"));
});
