import assert from "node:assert/strict";
import { test } from "node:test";
import { areAlike, cameraIn, placeIn, pointsIn } from "../../../static/viewer/state/frames.js";
import { DEFAULTS } from "../defaults.js";
import { random } from "../widgets/random.js";

/** @typedef {import("../../../static/viewer/state/frames.js").Frame} Frame */

/** Frames of many places and sizes. @param {number} count */
function someFrames(count) {
  const next = random(11);
  return Array.from({ length: count }, () => ({
    centre: [0, 1, 2].map(() => 200 * next() - 100),
    diagonal: 10 ** (4 * next() - 2),
  }));
}

/** Where a place of drawing coordinates lies in the file's unit, written out. @param {readonly number[]} place @param {Frame} frame */
const inTheFile = ([x, y, z], { centre: [a, b, c], diagonal }) => [
  a + x * diagonal,
  b + y * diagonal,
  c + z * diagonal,
];

/** @param {ArrayLike<number>} found @param {ArrayLike<number>} expected @param {number} [tolerance] */
function near(found, expected, tolerance = 1e-9) {
  assert.equal(found.length, expected.length);
  for (let k = 0; k < expected.length; k++)
    assert.ok(
      Math.abs(found[k] - expected[k]) <= tolerance * Math.max(1, Math.abs(expected[k])),
      `${Array.from(found)} is not ${Array.from(expected)}`,
    );
}

const A = { centre: [1, 2, 3], diagonal: 2 };
const B = { centre: [5, 2, -1], diagonal: 4 };

test("S6: a place is the same one in another frame, worked out by hand", () => {
  // (0.5, 0, -1) of A lies at (2, 2, 1); from B's centre that is (-3, 0, 2), in B's diagonals (-0.75, 0, 0.5).
  assert.deepEqual(placeIn([0.5, 0, -1], A, B), [-0.75, 0, 0.5]);
  assert.deepEqual(placeIn([0, 0, 0], A, A), [0, 0, 0]);
});

test("S6: places of any two frames are those of the file, there and back", () => {
  const frames = someFrames(40);
  const next = random(5);
  for (let k = 1; k < frames.length; k++) {
    const [from, to] = [frames[k - 1], frames[k]];
    const place = [next() - 0.5, next() - 0.5, next() - 0.5];
    const moved = placeIn(place, from, to);
    const size = Math.max(...frames.map(({ centre }) => Math.hypot(...centre)));
    near(inTheFile(moved, to), inTheFile(place, from), 1e-12 * size);
    near(placeIn(moved, to, from), place, (1e-13 * size) / from.diagonal);
  }
});

test("S6: a camera in another frame looks at the same point of the file from the same one", () => {
  const camera = { ...DEFAULTS.camera, target: /** @type {const} */ ([0.1, -0.2, 0.3]), distance: 1.25 };
  /** @param {typeof camera} one @param {Frame} frame */
  const eye = ({ target, direction, distance }, frame) =>
    inTheFile(
      target.map((place, axis) => place - distance * direction[axis]),
      frame,
    );
  const moved = cameraIn(camera, A, B);
  near(inTheFile(moved.target, B), inTheFile(camera.target, A));
  near(eye(moved, B), eye(camera, A));
  assert.equal(moved.distance, 0.625, "lengths of A are half as many of B's");
  const { target: _, distance: __, ...turned } = moved;
  const { target: ___, distance: ____, ...before } = camera;
  assert.deepEqual(turned, before, "it is turned, projected and fitted as before");
  const back = cameraIn(moved, B, A);
  near(back.target, camera.target);
  assert.equal(back.distance, camera.distance);
});

test("S6: a part of a camera stays the part that it is", () => {
  assert.deepEqual(cameraIn({ direction: /** @type {const} */ ([1, 0, 0]) }, A, B), { direction: [1, 0, 0] });
  assert.deepEqual(cameraIn({ distance: 3 }, A, B), { distance: 1.5 });
  assert.deepEqual(Object.keys(cameraIn({ target: /** @type {const} */ ([0, 0, 0]) }, A, B)), ["target"]);
  assert.deepEqual(cameraIn({ fit: true }, A, B), { fit: true });
  assert.deepEqual(cameraIn({}, A, B), {});
});

test("S6: points in another frame are the places of each of them", () => {
  const next = random(3);
  const points = Float32Array.from({ length: 30 }, () => next() - 0.5);
  const moved = pointsIn(points, A, B);
  assert.ok(moved instanceof Float32Array);
  for (let k = 0; k < points.length; k += 3)
    near(moved.subarray(k, k + 3), placeIn([...points.subarray(k, k + 3)], A, B), 1e-6);
  near(pointsIn(moved, B, A), points, 1e-6);
  assert.equal(pointsIn(new Float32Array(0), A, B).length, 0);
});

test("S6: frames are alike where both place and size differ by less than a twentieth of the diagonal", () => {
  const unit = { centre: [0, 0, 0], diagonal: 1 };
  assert.ok(areAlike(unit, unit));
  assert.ok(areAlike(unit, { centre: [0.049, 0, 0], diagonal: 1 }));
  assert.ok(!areAlike(unit, { centre: [0.051, 0, 0], diagonal: 1 }));
  assert.ok(!areAlike(unit, { centre: [0.03, 0.03, 0.03], diagonal: 1 }), "0.052 away, along all axes");
  assert.ok(areAlike(unit, { centre: [0, 0, 0], diagonal: 1.049 }));
  assert.ok(!areAlike(unit, { centre: [0, 0, 0], diagonal: 1.051 }));
  assert.ok(!areAlike(unit, { centre: [0, 0, 0], diagonal: 0.949 }));
  const large = { centre: [1000, 0, 0], diagonal: 100 };
  assert.ok(areAlike(large, { centre: [1004, 0, 0], diagonal: 100 }), "it is relative to the size");
});
