import assert from "node:assert/strict";
import { test } from "node:test";
import { compactIrregular, expandedIrregular } from "../../../static/viewer/exchange/compact_irregular.js";
import { fromPlanes, toPlanes } from "../../../static/viewer/exchange/planes.js";
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
    two_sided: false,
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
    two_sided: false,
  };
  assert.deepEqual(expanded(compact(surface)), surface);
});

test("A7 normals of faces are found again; those that their corners don't tell are kept", () => {
  const flat = [0, 0, 0, 1, 0, 0, 1, 1, 0.5, 0, 1, 0, /* a face without area */ 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0]; // prettier-ignore
  const positions = Float32Array.from(flat);
  // The cross of the diagonals 1 1 0.5 and -1 1 0 is -0.5 -0.5 2.
  const unit = [-0.5, -0.5, 2].map((part) => Math.round((32767 * part) / Math.hypot(0.5, 0.5, 2)));
  const rows = [unit, [0, 32767, 0]];
  const normals = Int16Array.from(rows.flatMap((row) => [0, 1, 2, 3].flatMap(() => [...row, 0])));
  const surface = {
    mode: /** @type {const} */ ("lines"),
    positions,
    normals,
    cells: new Uint32Array(8),
    inside: new Uint8Array(8),
    quads: null,
    faces: Uint32Array.of(0, 1),
    edges: new Float32Array(0),
    edge_cells: new Uint8Array(0),
    edge_faces: new Uint32Array(0),
    two_sided: false,
  };
  const kept = compact(surface);
  assert.deepEqual([...kept.normals], [0, 32767, 0]);
  assert.deepEqual([...kept.turned], [1]);
  assert.deepEqual(expanded(kept), surface);
});

test("A7 irregular edges come back as they were, without boundary ones where these are not drawn", () => {
  const irregular = {
    edges: Float32Array.of(0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 0, 0, 0, 0),
    valence: Uint8Array.of(3, 5, 1),
    boundary: Uint8Array.of(0, 0, 1),
    ends_on_boundary: Uint8Array.of(0, 2, 3),
    barbs: Float32Array.of(0, 0, 0, 0.45, 0, 0, 1, 0, 0, 1, 0.45, 0),
    barb_valence: Uint8Array.of(3, 1),
    barb_boundary: Uint8Array.of(0, 1),
    paper: Float32Array.from({ length: 12 }, (_, k) => k),
    paper_valence: Uint8Array.of(5),
    paper_boundary: Uint8Array.of(0),
    counts: { interior: { 3: 1 } },
  };
  const whole = compactIrregular(irregular, true);
  assert.ok(whole);
  assert.deepEqual(expandedIrregular(whole), irregular);
  const inner = compactIrregular(irregular, false);
  assert.ok(inner);
  assert.deepEqual(expandedIrregular(inner), {
    ...irregular,
    edges: irregular.edges.slice(0, 12),
    valence: Uint8Array.of(3, 5),
    boundary: Uint8Array.of(0, 0),
    ends_on_boundary: Uint8Array.of(0, 2),
    barbs: irregular.barbs.slice(0, 6),
    barb_valence: Uint8Array.of(3),
    barb_boundary: Uint8Array.of(0),
  });
  assert.equal(compactIrregular(undefined, true), null);
});

test("A7 arrays come back from their planes, wherever they stand", () => {
  const record = {
    list: [Float32Array.of(1.5, -2, 1e-30), { deep: Int16Array.of(-1, 300), text: "planes" }],
    bytes: Uint8Array.of(1, 2, 3),
    none: null,
    part: new Uint32Array(Uint32Array.of(9, 8, 7, 4e9).buffer, 4, 3),
  };
  const planes = /** @type {{ part: { planes: Uint8Array } }} */ (toPlanes(record));
  assert.deepEqual([...planes.part.planes].slice(0, 3), [8, 7, 4e9 & 255]);
  assert.deepEqual(fromPlanes(planes), { ...record, part: Uint32Array.of(8, 7, 4e9) });
});
