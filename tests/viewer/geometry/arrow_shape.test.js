import assert from "node:assert/strict";
import { test } from "node:test";

import { arrowShape } from "../../../static/viewer/geometry/arrow_shape.js";

const STAND = [0, 0.66, 1];
const BREADTH = [0, 0.03, 0.1];

/** The body of an arrow along z, filled in as the shader does. @param {number} sides */
function body(sides) {
  const { rings, turns, index } = arrowShape(sides);
  const count = turns.length / 2;
  const points = Array.from({ length: count }, (_, v) => {
    const [stand, breadth] = [STAND[rings[4 * v]], BREADTH[rings[4 * v + 1]]];
    return [breadth * turns[2 * v], breadth * turns[2 * v + 1], stand];
  });
  const normals = Array.from({ length: count }, (_, v) => [
    rings[4 * v + 2] * turns[2 * v],
    rings[4 * v + 2] * turns[2 * v + 1],
    rings[4 * v + 3],
  ]);
  const triangles = Array.from({ length: index.length / 3 }, (_, t) => [...index.subarray(3 * t, 3 * t + 3)]);
  return { points, normals, triangles };
}

const dot = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const less = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a.map((part, k) => part - b[k]);
const cross = (/** @type {number[]} */ a, /** @type {number[]} */ b) => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

for (const sides of [3, 8, 13]) {
  test(`R8: an arrow of ${sides} sides is closed, its faces look outward, and so do its normals`, () => {
    const { points, normals, triangles } = body(sides);
    /** @type {Map<string, number>} */
    const crossed = new Map();
    const name = (/** @type {number} */ v) =>
      points[v].map((part) => part.toFixed(6).replace("-0.000000", "0.000000")).join();
    let volume = 0;
    for (const [a, b, c] of triangles) {
      for (const [from, to] of [
        [a, b],
        [b, c],
        [c, a],
      ]) {
        const key = `${name(from)} ${name(to)}`;
        assert.notEqual(name(from), name(to), "no triangle has lost a side");
        assert.ok(!crossed.has(key), "no edge is crossed twice the same way");
        crossed.set(key, 1);
      }
      const normal = cross(less(points[b], points[a]), less(points[c], points[a]));
      const size = Math.sqrt(dot(normal, normal));
      for (const v of [a, b, c]) assert.ok(dot(normal, normals[v]) > 0.3 * size, `normal ${v}`);
      volume += dot(points[a], cross(points[b], points[c])) / 6;
    }
    for (const key of crossed.keys()) assert.ok(crossed.has(key.split(" ").reverse().join(" ")), "closed");
    const section = (sides / 2) * Math.sin((2 * Math.PI) / sides);
    const expected = section * (0.03 ** 2 * 0.66 + (0.1 ** 2 * 0.34) / 3);
    assert.ok(Math.abs(volume - expected) < 1e-6 * expected + 1e-9, `${volume} ${expected}`);
    for (const normal of normals) assert.ok(Math.abs(Math.sqrt(dot(normal, normal)) - 1) < 0.01);
  });
}
