import assert from "node:assert/strict";
import { test } from "node:test";
import { compact, expanded } from "../../../static/viewer/exchange/compact_surface.js";
import { welded } from "../../../static/viewer/exchange/welded.js";

/** Numbers that come again the same on every run (Park and Miller). @param {number} seed */
function random(seed) {
  let state = seed;
  return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

test("A8 corners at one place and of one colour are one vertex", () => {
  const next = random(7);
  const count = 5000;
  const points = Float32Array.from({ length: 3 * count }, () => Math.floor(9 * next()) / 3 - 1);
  points[0] = -0; // is where 0 is
  const colours = Uint8Array.from({ length: 3 * count }, () => Math.floor(2 * next()) * 255);
  for (const given of [undefined, colours]) {
    const { ids, firsts } = welded(points, given);
    const places = new Map();
    for (let corner = 0; corner < count; corner++) {
      const key = JSON.stringify([
        [...points.subarray(3 * corner, 3 * corner + 3)].map((number) => number + 0),
        given ? [...given.subarray(3 * corner, 3 * corner + 3)] : null,
      ]);
      if (!places.has(key)) places.set(key, { id: places.size, corner });
      assert.equal(ids[corner], places.get(key).id);
    }
    assert.deepEqual([...firsts], [...places.values()].map(({ corner }) => corner)); // prettier-ignore
  }
});

test("A7 a flat surface comes back as it was", () => {
  const next = random(3);
  const faces = 40;
  const face = (/** @type {() => number[]} */ make) => Array.from({ length: faces }, () => make());
  const four = (/** @type {number[][]} */ rows) => rows.flatMap((row) => [row, row, row, row].flat());
  const positions = Float32Array.from({ length: 12 * faces }, () => Math.floor(5 * next()) / 7);
  const cells = face(() => [Math.floor(900 * next())]);
  /** @type {import("../../../static/viewer/geometry/records.js").Surface} */
  const surface = {
    mode: "lines",
    positions,
    normals: Int16Array.from(
      four(face(() => [1, 2, 3].map(() => Math.round(60000 * next() - 30000)).concat(0))),
    ),
    cells: Uint32Array.from(four(cells)),
    inside: Uint8Array.from(four(face(() => [255 * Math.round(next())]))),
    quads: null,
    faces: Uint32Array.from(cells.flat(), (cell) => 8 * cell + 5),
    edges: positions.slice(0, 60),
    edge_cells: Uint8Array.of(1, 2, 3),
    edge_faces: Uint32Array.of(0, 1, 2, 3),
  };
  assert.deepEqual(expanded(compact(surface)), surface);
});

test("A7 a surface with shared vertices comes back as it was, and a triangle stays one", () => {
  /** @type {import("../../../static/viewer/geometry/records.js").Surface} */
  const surface = {
    mode: "rounded",
    positions: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 0),
    normals: Int16Array.from({ length: 20 }, (_, k) => (k % 4 === 3 ? 0 : 100 * k)),
    cells: Uint32Array.of(4, 4, 4, 2, 2),
    inside: Uint8Array.of(0, 255, 0, 255, 0),
    quads: Uint32Array.of(0, 1, 2, 3, 4, 1, 2, 2),
    faces: Uint32Array.of(33, 17),
    edges: new Float32Array(0),
    edge_cells: new Uint8Array(0),
    edge_faces: new Uint32Array(0),
  };
  assert.deepEqual(expanded(compact(surface)), surface);
});
