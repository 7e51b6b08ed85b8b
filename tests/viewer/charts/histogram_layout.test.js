import assert from "node:assert/strict";
import { test } from "node:test";
import { along, layOut, valueUnder } from "../../../static/viewer/charts/histogram_layout.js";
import { niceTicks, tickText } from "../../../static/viewer/charts/ticks.js";

const DATA = {
  edges: [0, 0.25, 0.5, 0.75, 1],
  counts: [0, 10, 5, 1],
  map_position: [1, 0.7, 0.4, 0],
  low: 0,
  high: 1,
};

for (const orientation of /** @type {const} */ (["horizontal", "vertical"])) {
  const frame = { width: 288, height: 132, orientation, scale: /** @type {const} */ ("linear") };

  test(`Q4: every value lies under the pixel it is drawn at, ${orientation}`, () => {
    const layout = layOut(DATA, frame);
    for (const value of [0, 0.1, 0.5, 0.99, 1])
      assert.ok(Math.abs(valueUnder(layout, along(layout, value)) - value) < 1e-12);
  });

  test(`Q4: a unit has room at the axis, and leaves the bars theirs, ${orientation}`, () => {
    const plain = layOut(DATA, frame);
    const named = layOut(DATA, { ...frame, unit: "mm³" });
    assert.equal(named.unit, "mm³");
    assert.equal(plain.unit, "");
    assert.equal(plain.plot.height - named.plot.height, orientation === "horizontal" ? 14 : 0);
    assert.equal(plain.plot.y, named.plot.y);
  });

  test(`Q4: bars keep inside the plot, are as long as their counts, and empty bins have none, ${orientation}`, () => {
    const { bars, plot, upright } = layOut(DATA, frame);
    assert.deepEqual(bars.map(({ bin }) => bin), [1, 2, 3]); // prettier-ignore
    const length = bars.map(({ box }) => (upright ? box.height : box.width));
    assert.ok(Math.abs(length[1] / length[0] - 0.5) < 1e-9);
    for (const { box } of bars) {
      assert.ok(box.x >= plot.x - 1e-9 && box.x + box.width <= plot.x + plot.width + 1e-9);
      assert.ok(box.y >= plot.y - 1e-9 && box.y + box.height <= plot.y + plot.height + 1e-9);
    }
  });
}

test("Q4: with logarithmic counts a single cell among a million is still seen", () => {
  const data = { ...DATA, counts: [0, 1e6, 0, 1] };
  const { bars, plot } = layOut(data, { width: 288, height: 132, orientation: "horizontal", scale: "log" });
  assert.ok(bars[1].box.height > plot.height * 0.04);
});

test("Q4: values that are all the same stand in the middle", () => {
  const layout = layOut(
    { edges: [2, 2], counts: [8], map_position: [0], low: 2, high: 2 },
    { width: 288, height: 132, orientation: "horizontal", scale: "linear" },
  );
  assert.equal(along(layout, 2), layout.plot.x + layout.plot.width / 2);
  assert.deepEqual(layout.ticks.map(({ value }) => value), [2]); // prettier-ignore
});

test("ticks are round, inside, and about as many as asked for", () => {
  assert.deepEqual(niceTicks(0, 1, 5), [0, 0.2, 0.4, 0.6000000000000001, 0.8, 1]);
  assert.deepEqual(niceTicks(0, 1, 5).map(tickText), ["0", "0.2", "0.4", "0.6", "0.8", "1"]); // prettier-ignore
  for (const [low, high] of [
    [-3.2e-6, 4.1e-6],
    [12, 9000],
    [-1, 1],
  ]) {
    // prettier-ignore
    const ticks = niceTicks(low, high, 5);
    assert.ok(ticks.length >= 2 && ticks.length <= 8, String(ticks));
    assert.ok(ticks.every((tick) => tick >= low - 1e-12 && tick <= high + 1e-12));
  }
});

test("ranges that pass what a number holds have places and ticks", () => {
  const chart = { plot: { x: 0, y: 0, width: 100, height: 50 }, upright: true, low: -1.7e308, high: 1.7e308 };
  assert.equal(along(chart, 0), 50);
  assert.equal(along(chart, 1.7e308), 100);
  assert.ok(Math.abs(valueUnder(/** @type {any} */ (chart), 50)) < 1e295);
  const ticks = niceTicks(-1.7e308, 1.7e308, 7);
  assert.ok(ticks.length >= 3 && ticks.every(Number.isFinite), String(ticks));
  assert.equal(along({ ...chart, low: 5e-324, high: 1.5e-323 }, 5e-324), 0);
});

test("S5: ticks far from 1 are told in three digits, so that no two that differ read alike", () => {
  const values = [0.00025, 0.0003, 5e-4, -1.234567e-5, 123456, 2.5e6, 1e5];
  assert.deepEqual(values.map(tickText), ["2.5e−4", "3e−4", "5e−4", "−1.23e−5", "1.23e5", "2.5e6", "1e5"]); // prettier-ignore
});

for (const orientation of /** @type {const} */ (["horizontal", "vertical"]))
  for (const scale of /** @type {const} */ (["linear", "log"])) {
    const frame = { width: 288, height: 132, orientation, scale };

    test(`S6: a second mesh's outline stands on the scale of the bars, ${orientation}, ${scale}`, () => {
      const same = { edges: DATA.edges, counts: DATA.counts };
      const { bars, steps, plot, upright } = layOut({ ...DATA, beside: same }, frame);
      const room = upright ? plot.height : plot.width;
      for (const { bin, box } of bars) {
        const length = upright ? box.height : box.width;
        const [start, stop] = steps.slice(1 + 2 * bin, 3 + 2 * bin);
        assert.deepEqual([start[0], stop[0]], [DATA.edges[bin], DATA.edges[bin + 1]]);
        assert.ok(Math.abs(start[1] * room - length) < 1e-9 && start[1] === stop[1]);
      }
      assert.equal(steps.length, 2 * DATA.counts.length + 2);
    });

    test(`S6: the largest count is that of both meshes, ${orientation}, ${scale}`, () => {
      const beside = { edges: DATA.edges, counts: [0, 0, 40, 0] };
      const layout = layOut({ ...DATA, beside }, frame);
      assert.equal(layout.highest, 40);
      assert.equal(Math.max(...layout.steps.map(([, share]) => share)), 1);
      const longest = layout.bars[0].box;
      const room = layout.upright ? layout.plot.height : layout.plot.width;
      const share = scale === "log" ? Math.log(11) / Math.log(41) : 10 / 40;
      assert.ok(Math.abs((layout.upright ? longest.height : longest.width) - share * room) < 1e-9);
      assert.equal(layOut({ ...DATA, beside: { ...beside, counts: [1, 1, 1, 1] } }, frame).highest, 10);
    });
  }

test("S6: without a second mesh, or where no mesh has a value, there is no outline", () => {
  const frame = /** @type {const} */ ({
    width: 288,
    height: 132,
    orientation: "horizontal",
    scale: "linear",
  });
  assert.deepEqual(layOut(DATA, frame).steps, []);
  assert.deepEqual(layOut({ ...DATA, beside: null }, frame).steps, []);
  const none = { ...DATA, counts: [0, 0, 0, 0], beside: { edges: DATA.edges, counts: [0, 0, 0, 0] } };
  assert.deepEqual(layOut(none, frame).steps, []);
});

test("S6: scaled counts have a largest one in whole cells, and none stands out of the plot", () => {
  const frame = /** @type {const} */ ({
    width: 288,
    height: 132,
    orientation: "horizontal",
    scale: "linear",
  });
  const { highest, steps } = layOut(
    { ...DATA, beside: { edges: DATA.edges, counts: [0, 33.4, 0, 0] } },
    frame,
  );
  assert.equal(highest, 33);
  assert.equal(Math.max(...steps.map(([, share]) => share)), 1);
});
