import assert from "node:assert/strict";
import { test } from "node:test";

import { DIRECTIONS, directions } from "../../../static/viewer/lighting/directions.js";

/** A mulberry generator: numbers from 0 to 1, the same on every run. @param {number} seed */
function random(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/**
 * Root mean square difference, over random caps of the sphere, between the share of points in the cap and its share of the area.
 *
 * @param {Float64Array} points
 * @param {number} count of them, from the first
 */
function discrepancy(points, count) {
  const next = random(7);
  let squares = 0;
  for (let cap = 0; cap < 800; cap++) {
    const z = 2 * next() - 1;
    const angle = 2 * Math.PI * next();
    const r = Math.sqrt(1 - z * z);
    const axis = [r * Math.cos(angle), z, r * Math.sin(angle)];
    const height = 2 * next() - 1;
    let inside = 0;
    for (let k = 0; k < count; k++) {
      if (points[3 * k] * axis[0] + points[3 * k + 1] * axis[1] + points[3 * k + 2] * axis[2] > height)
        inside++;
    }
    squares += (inside / count - (1 - height) / 2) ** 2;
  }
  return Math.sqrt(squares / 800);
}

test("V5: there are 1024 directions, unit vectors, the same on every run", () => {
  const points = directions();
  assert.equal(points.length, 3 * DIRECTIONS);
  assert.equal(DIRECTIONS, 1024);
  for (let k = 0; k < DIRECTIONS; k++) {
    assert.ok(Math.abs(Math.hypot(...points.subarray(3 * k, 3 * k + 3)) - 1) < 1e-12);
  }
  assert.deepEqual(directions(), points);
  assert.deepEqual(directions(64), points.slice(0, 3 * 64));
});

test("V5: every prefix is spread more evenly than chance spreads it", () => {
  const points = directions();
  const next = random(1);
  for (const count of [6, 8, 16, 33, 64, 100, 256, 500, 1024]) {
    let chance = 0;
    for (let trial = 0; trial < 8; trial++) {
      const rival = new Float64Array(3 * count);
      for (let k = 0; k < count; k++) {
        const z = 2 * next() - 1;
        const angle = 2 * Math.PI * next();
        rival.set([Math.sqrt(1 - z * z) * Math.cos(angle), z, Math.sqrt(1 - z * z) * Math.sin(angle)], 3 * k);
      }
      chance += discrepancy(rival, count) / 8;
    }
    const found = discrepancy(points, count);
    assert.ok(found < 0.7 * chance, `${count} directions: ${found.toFixed(3)}, chance ${chance.toFixed(3)}`);
    assert.ok(found < 0.5 * count ** -0.7, `${count} directions: ${found.toFixed(3)} falls too slowly`);
  }
});

test("V5: light on an open face is the cosine law's, whichever way it faces", () => {
  const points = directions();
  const next = random(3);
  for (let trial = 0; trial < 50; trial++) {
    const normal = [next() - 0.5, next() - 0.5, next() - 0.5];
    const length = Math.hypot(...normal);
    let sum = 0;
    for (let k = 0; k < DIRECTIONS; k++) {
      const cosine = [0, 1, 2].reduce((dot, c) => dot + (points[3 * k + c] * normal[c]) / length, 0);
      sum += Math.max(0, cosine);
    }
    assert.ok(Math.abs(sum / DIRECTIONS - 0.25) < 0.002, `mean cosine ${sum / DIRECTIONS}`);
  }
});
