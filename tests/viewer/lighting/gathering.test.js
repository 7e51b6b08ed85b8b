import assert from "node:assert/strict";
import { test } from "node:test";

import { lightView } from "../../../static/viewer/lighting/light_view.js";
import { gatheringPoints, packNormal } from "../../../static/viewer/lighting/samples.js";
import { vertexRows, vertexTexel } from "../../../static/viewer/geometry/texel.js";

/** GLSL's unpackSnorm2x16 and the octahedral mapping undone. @param {number} word */
function unpackNormal(word) {
  const [u, v] = [(word << 16) >> 16, word >> 16].map((half) => Math.max(-1, half / 32767));
  const n = [u, v, 1 - Math.abs(u) - Math.abs(v)];
  if (n[2] < 0) {
    n[0] = (1 - Math.abs(v)) * (u < 0 ? -1 : 1);
    n[1] = (1 - Math.abs(u)) * (v < 0 ? -1 : 1);
  }
  const length = Math.hypot(...n);
  return n.map((c) => c / length);
}

test("V5: normals survive packing into 32 bits, the folds of the octahedron included", () => {
  for (const n of [
    [0, 0, 1],
    [0, 0, -1],
    [1, 0, 0],
    [0, -1, 0],
    [-0.6, 0, -0.8],
    [0.48, -0.6, -0.64],
    [-0.36, -0.48, 0.8],
  ]) {
    const [x, y, z] = n.map((c) => c * 32767);
    const back = unpackNormal(packNormal(x, y, z));
    n.forEach((c, k) => assert.ok(Math.abs(c - back[k]) < 2e-4, `${n} ${back}`));
  }
});

test("V5: every drawn vertex has a texel of its own, the four of a flat face in one block", () => {
  const seen = new Set();
  const count = 10_000;
  for (let vertex = 0; vertex < count; vertex++) {
    const texel = vertexTexel(vertex);
    assert.ok(texel < vertexRows(count) * 2048);
    seen.add(texel);
    const [x, y] = [texel % 2048, Math.floor(texel / 2048)];
    const first = vertexTexel(vertex & ~3);
    assert.equal(x >> 1, first % 2048 >> 1);
    assert.equal(y >> 1, Math.floor(first / 2048) >> 1);
  }
  assert.equal(seen.size, count);
});

test("V5: the view from a direction holds the box, nearer to the light being nearer", () => {
  const box = [-0.3, -0.2, -0.1, 0.3, 0.25, 0.4];
  for (const d of [
    [0, 0, 1],
    [0, 0, -1],
    [0.6, 0, -0.8],
    [-0.48, 0.6, 0.64],
  ]) {
    const { x, y, z } = lightView(d, box, 0.01);
    const dot = (/** @type {readonly number[]} */ row, /** @type {readonly number[]} */ p) =>
      row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
    for (let corner = 0; corner < 8; corner++) {
      const p = [0, 1, 2].map((c) => box[c + 3 * ((corner >> c) & 1)]);
      for (const row of [x, y]) assert.ok(Math.abs(dot(row, p)) <= 0.98 + 1e-9);
      assert.ok(Math.abs(dot(z, p)) <= 1);
      const lit = p.map((c, k) => c + 0.01 * d[k]);
      assert.ok(dot(z, lit) < dot(z, p));
      assert.ok(Math.abs(dot(x, lit) - dot(x, p)) < 1e-9);
    }
  }
});

test("V5: a flat face's corners gather inside the face, on its surface", () => {
  /** @type {import("../../../static/viewer/geometry/records.js").Surface} */
  const surface = {
    mode: "lines",
    positions: new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0.5, 0, 1, 0]),
    normals: new Int16Array(16).fill(32767),
    cells: new Uint32Array(4),
    inside: new Uint8Array(4),
    quads: null,
    faces: new Uint32Array(1),
    edges: new Float32Array(0),
    edge_cells: new Uint8Array(0),
    edge_faces: new Uint32Array(0),
    two_sided: false,
  };
  const { words, box } = gatheringPoints(surface, null);
  const floats = new Float32Array(words.buffer);
  assert.deepEqual([...box], [0, 0, 0, 1, 1, 0.5]);
  for (let corner = 0; corner < 4; corner++) {
    const at = 4 * vertexTexel(corner);
    const [x, y, z] = floats.subarray(at, at + 3);
    assert.ok(x > 0 && x < 1 && y > 0 && y < 1);
    // The two triangles meet at the diagonal from corner 0 to 2: below it z = y / 2, above it z = x / 2.
    assert.ok(Math.abs(z - Math.min(x, y) / 2) < 1e-6);
  }
});
