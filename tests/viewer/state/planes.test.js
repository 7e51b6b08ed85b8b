import assert from "node:assert/strict";
import { test } from "node:test";
import { anotherPlane, fromView, inverted } from "../../../static/viewer/state/planes.js";

/** @type {import("../../../static/viewer/state/planes.js").Plane} */
const PLANE = { enabled: true, normal: [1, 0, 0], offset: 0.3 };

/** @param {number} degrees */
const at = (degrees) =>
  /** @type {[number, number, number]} */ ([
    Math.cos((degrees * Math.PI) / 180),
    Math.sin((degrees * Math.PI) / 180),
    0,
  ]);

test("F1: set plane takes the view direction as normal", () => {
  const plane = fromView(PLANE, [0, 0, -4], false);
  assert.deepEqual(plane.normal, [0, 0, -1]);
  assert.equal(plane.offset, 0.3);
});

test("F1: with shift, the nearest signed axis", () => {
  assert.deepEqual(fromView(PLANE, [0.2, -0.9, 0.4], true), { ...PLANE, normal: [0, -1, 0] });
  const upright = { ...PLANE, normal: /** @type {const} */ ([0, 1, 0]) };
  assert.deepEqual(fromView(upright, [0.8, -0.5, 0.4], true), { ...PLANE, normal: [1, 0, 0] });
});

test("F1: within 20 degrees of opposite the plane is exactly inverted, beyond it is not", () => {
  assert.deepEqual(fromView(PLANE, at(180 - 19.9), false), {
    enabled: true,
    normal: [-1, 0, 0],
    offset: 0.7,
  });
  assert.deepEqual(fromView(PLANE, at(180 - 20.1), false).normal, at(180 - 20.1));
  assert.deepEqual(fromView(PLANE, at(180 - 20.1), true).normal, [-1, 0, 0]);
});

test("F1: that holds for a normal of any direction and length, with shift and without", () => {
  const plane = { enabled: true, normal: /** @type {const} */ ([1, 2, -0.5]), offset: 0.25 };
  const length = Math.hypot(...plane.normal);
  const sideways = [2 / Math.sqrt(5), -1 / Math.sqrt(5), 0]; // at right angles to the normal
  for (const [degrees, inverts] of /** @type {const} */ ([
    [0, true],
    [19.9, true],
    [20.1, false],
    [90, false],
  ])) {
    const angle = (degrees * Math.PI) / 180;
    const [x, y, z] = plane.normal.map(
      (part, axis) => -((Math.cos(angle) * part) / length + Math.sin(angle) * sideways[axis]),
    );
    for (const snap of [false, true]) {
      const found = fromView(plane, [x, y, z], snap);
      const inverted = { enabled: true, normal: [-1, -2, 0.5], offset: 0.75 };
      if (inverts) assert.deepEqual(found, inverted);
      else assert.notDeepEqual(found, inverted);
    }
  }
});

test("F1: inverting twice gives the plane back", () => {
  assert.deepEqual(inverted(inverted(PLANE)), PLANE);
  assert.ok(!inverted(PLANE).normal.some((x) => Object.is(x, -0)));
});

test("F1: a further plane takes an axis that is not used", () => {
  assert.deepEqual(anotherPlane([PLANE]).normal, [0, 1, 0]);
  assert.deepEqual(anotherPlane([PLANE, { ...PLANE, normal: [0, 1, 0] }]).normal, [0, 0, 1]);
});

test("F1: setting a plane from the view switches it on, inverted or not", () => {
  const off = { ...PLANE, enabled: false };
  assert.equal(fromView(off, at(10), false).enabled, true);
  assert.equal(fromView(off, at(175), false).enabled, true);
});
