import assert from "node:assert/strict";
import { test } from "node:test";
import { PairIndex } from "../../../../static/viewer/widgets/matrix/pair_index.js";
import { DIAGONAL, NOTHING, raster } from "../../../../static/viewer/widgets/matrix/raster.js";
import { dense, somePairs } from "./some_pairs.js";

/** What a place shows. @param {Uint8Array} all @param {number} count @param {number} row @param {number} column */
const shown = (all, count, row, column) =>
  all[row * count + column] ? DIAGONAL + all[row * count + column] : row === column ? DIAGONAL : NOTHING;

/** The same by looking at every place. @param {Uint8Array} all @param {number} count @param {{ x: number, y: number, size: number }} window @param {number} pixels */
function slowly(all, count, { x, y, size }, pixels) {
  const scale = pixels / size;
  const gap = scale >= 6 ? 1 : 0;
  const out = new Uint8Array(pixels * pixels);
  const span = (/** @type {number} */ start) => {
    const from = Math.floor(start * scale);
    return [from, Math.max(from + 1, Math.floor((start + 1) * scale) - gap)];
  };
  for (let row = 0; row < count; row++)
    for (let column = 0; column < count; column++) {
      const [[top, bottom], [left, right]] = [span(row - y), span(column - x)];
      for (let v = Math.max(0, top); v < Math.min(pixels, bottom); v++)
        for (let u = Math.max(0, left); u < Math.min(pixels, right); u++)
          out[v * pixels + u] = Math.max(out[v * pixels + u], shown(all, count, row, column));
    }
  return out;
}

const PIXELS = 60;

for (const [name, count, window] of /** @type {const} */ ([
  ["one thing", 1, { x: 0, y: 0, size: 1 }],
  ["few things", 7, { x: 0, y: 0, size: 7 }],
  ["as many things as pixels", 60, { x: 0, y: 0, size: 60 }],
  ["a little more things than pixels", 83, { x: 0, y: 0, size: 83 }],
  ["many things on a pixel", 200, { x: 0, y: 0, size: 200 }],
  ["a part that begins within a cell", 50, { x: 10.4, y: 31.7, size: 12.9 }],
  ["a part off the diagonal", 90, { x: 70.25, y: 3.5, size: 10 }],
]))
  test(`T4: the picture of ${name} is that of all places, one by one`, () => {
    const pairs = somePairs(count, Math.ceil(count / 2), 9);
    assert.deepEqual(
      raster(new PairIndex(pairs), window, PIXELS),
      slowly(dense(pairs), count, window, PIXELS),
    );
  });

test("T4: a single pair of five thousand things is seen, twice", () => {
  const pairs = { count: 5000, one: [10], other: [4000], crossings: [1], beside: [0] };
  const picture = raster(new PairIndex(pairs), { x: 0, y: 0, size: 5000 }, 288);
  assert.equal(picture.filter((value) => value > DIAGONAL).length, 2);
  assert.equal(picture[0 * 288 + Math.floor((4000 * 288) / 5000)], DIAGONAL + 1);
});

test("T4: a picture is drawn over an older one", () => {
  const index = new PairIndex(somePairs(30, 60, 2));
  const old = new Uint8Array(PIXELS * PIXELS).fill(4);
  const window = { x: 0, y: 0, size: 30 };
  assert.deepEqual(raster(index, window, PIXELS, old), raster(index, window, PIXELS));
});

test("T4: a million pairs are drawn while a hand moves, and of a part only what is in sight", () => {
  const index = new PairIndex(somePairs(5000, 1_000_000, 3));
  const time = (/** @type {{ x: number, y: number, size: number }} */ window) => {
    const times = [1, 2, 3].map(() => {
      const start = performance.now();
      raster(index, window, 576);
      return performance.now() - start;
    });
    return Math.min(...times);
  };
  const [all, part] = [time({ x: 0, y: 0, size: 5000 }), time({ x: 800, y: 2000, size: 250 })];
  assert.ok(all < 400, `all of it took ${all.toFixed(0)} ms`);
  assert.ok(part < all, `a part took ${part.toFixed(1)} ms, all ${all.toFixed(1)}`);
});
