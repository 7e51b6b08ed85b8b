import assert from "node:assert/strict";
import { test } from "node:test";
import * as windows from "../../../../static/viewer/widgets/matrix/window.js";

const COUNT = 100;
const WHOLE = windows.whole(COUNT);

/** @param {number} one @param {number} other */
const near = (one, other) => assert.ok(Math.abs(one - other) < 1e-9, `${one}, not ${other}`);

test("T4: zooming keeps what is under the pointer there", () => {
  const point = { x: 0.3, y: 0.8 };
  let window = WHOLE;
  for (const factor of [2, 1.7, 3, 0.9]) {
    const before = [window.x + point.x * window.size, window.y + point.y * window.size];
    window = windows.zoomed(window, factor, point, COUNT);
    near(window.x + point.x * window.size, before[0]);
    near(window.y + point.y * window.size, before[1]);
  }
  near(window.size, COUNT / (2 * 1.7 * 3 * 0.9));
});

test("T4: a window stays within the matrix, and no less than a few things are seen", () => {
  let window = windows.zoomed(WHOLE, 1e6, { x: 1, y: 0 }, COUNT);
  assert.deepEqual(window, { x: 96, y: 0, size: 4 });
  window = windows.dragged(window, { x: -9, y: 9 }, COUNT);
  assert.deepEqual(window, { x: 96, y: 0, size: 4 });
  assert.deepEqual(windows.zoomed(window, 1e-6, { x: 0.5, y: 0.5 }, COUNT), WHOLE);
  assert.deepEqual(windows.zoomed(windows.whole(1), 2, { x: 0.5, y: 0.5 }, 1), windows.whole(1));
});

test("T4: a drag takes along what the hand holds", () => {
  const window = windows.zoomed(WHOLE, 4, { x: 0.5, y: 0.5 }, COUNT);
  const place = windows.placeUnder(window, { x: 0.5, y: 0.5 }, COUNT);
  const moved = windows.dragged(window, { x: 0.25, y: -0.125 }, COUNT);
  assert.deepEqual(windows.placeUnder(moved, { x: 0.75, y: 0.375 }, COUNT), place);
});

test("T4: every cell lies under its middle, and what is past the rim is the last one", () => {
  const window = { x: 20.5, y: 60.25, size: 12 };
  for (const place of [{ row: 61, column: 21 }, { row: 71, column: 31 }]) // prettier-ignore
    assert.deepEqual(windows.placeUnder(window, windows.pointOf(window, place), COUNT), place);
  assert.deepEqual(windows.placeUnder(WHOLE, { x: 1, y: -0.01 }, COUNT), { row: 0, column: 99 });
});

test("T4: a cell comes into sight, and one in sight moves nothing", () => {
  const window = { x: 20, y: 20, size: 10 };
  assert.deepEqual(windows.reaching(window, { row: 25, column: 29 }, COUNT), window);
  assert.deepEqual(windows.reaching(window, { row: 30, column: 3 }, COUNT), { x: 3, y: 21, size: 10 });
  assert.deepEqual(windows.reaching(WHOLE, { row: 99, column: 0 }, COUNT), WHOLE);
});

test("T4: the wheel is left to the page where it leads nowhere", () => {
  const close = windows.zoomed(WHOLE, 1e6, { x: 0, y: 0 }, COUNT);
  assert.ok(windows.leadsSomewhere(WHOLE, 1.1, COUNT));
  assert.ok(!windows.leadsSomewhere(WHOLE, 0.9, COUNT));
  assert.ok(windows.leadsSomewhere(close, 0.9, COUNT));
  assert.ok(windows.leadsSomewhere(close, 1.1, COUNT), "a hand that goes on scrolls nothing");
  assert.ok(!windows.leadsSomewhere(windows.whole(3), 1.1, 3));
});
