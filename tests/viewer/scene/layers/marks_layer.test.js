import assert from "node:assert/strict";
import { test } from "node:test";

import { LOST, MARK_STYLES, markColour } from "../../../../static/viewer/colours/marks.js";
import { MarksLayer } from "../../../../static/viewer/scene/layers/marks_layer.js";

const VIEW = /** @type {any} */ ({ pixel: 0.002, pixelRatio: 2, width: 640, height: 480, draft: false });

const NONE = {
  faces: new Float32Array(0),
  face_colours: new Uint8Array(0),
  edges: new Float32Array(0),
  edge_colours: new Uint8Array(0),
  points: new Float32Array(0),
  point_colours: new Uint8Array(0),
  counts: {},
};

/** A square at a height. @param {number} z */
const square = (z) => [0, 0, z, 1, 0, z, 1, 1, z, 0, 1, z];

/** @param {MarksLayer} layer */
function drawn(layer) {
  const [faces, edges, points] = /** @type {any[]} */ (layer.group.children);
  return { faces, edges, points };
}

/** @param {any} mesh */
const coloursOf = (mesh) => [...mesh.geometry.getAttribute("colour").array];

/** @param {number} row */
const bytesOf = (row) =>
  [1, 3, 5].map((at) => Number.parseInt(MARK_STYLES[row].colour.slice(at, at + 2), 16));

test("R13: faces, edges and points are drawn where there are any, each with its colour", () => {
  const layer = new MarksLayer();
  layer.set({
    ...NONE,
    faces: Float32Array.from([...square(0), ...square(1)]),
    face_colours: Uint8Array.from([2, LOST]),
    points: Float32Array.from([0, 0, 5]),
    point_colours: Uint8Array.from([4]),
  });
  const { faces, edges, points } = drawn(layer);
  assert.deepEqual([faces.visible, edges.visible, points.visible], [true, false, true]);
  assert.equal(faces.geometry.drawRange.count, 12, "two triangles for each of two squares");
  const four = (/** @type {number[]} */ colour) => [...colour, ...colour, ...colour, ...colour];
  assert.deepEqual(coloursOf(faces), [...four(bytesOf(2)), ...four(bytesOf(LOST))]);
  assert.deepEqual(coloursOf(points), bytesOf(4));
  layer.set({ ...NONE, edges: Float32Array.from([0, 0, 0, 1, 1, 1]), edge_colours: Uint8Array.from([LOST]) });
  assert.deepEqual([faces.visible, edges.visible, points.visible], [false, true, false]);
  layer.set(null);
  assert.equal(edges.visible, false, "another mesh has no marks yet");
});

test("R13: a face in no group is light enough for the body to be read below; a point is ink", () => {
  const [ungrouped, brightness] = [6, (/** @type {number[]} */ rgb) => Math.min(...rgb)];
  const layer = new MarksLayer();
  layer.set({
    ...NONE,
    faces: Float32Array.from(square(0)),
    face_colours: Uint8Array.from([ungrouped]),
    points: Float32Array.from([0, 0, 5]),
    point_colours: Uint8Array.from([ungrouped]),
  });
  const { faces, points } = drawn(layer);
  assert.ok(brightness(coloursOf(faces)) > 128);
  assert.ok(brightness(coloursOf(points)) < 64);
});

test("R13: what is marked lies within the box, so that it is not cut by the camera's planes", () => {
  const layer = new MarksLayer();
  layer.set({
    ...NONE,
    faces: Float32Array.from(square(1)),
    face_colours: Uint8Array.from([0]),
    edges: Float32Array.from([-2, 0, 0, 0, 3, 0]),
    edge_colours: Uint8Array.from([0]),
    points: Float32Array.from([0, 0, -4]),
    point_colours: Uint8Array.from([0]),
  });
  assert.deepEqual([layer.box?.low, layer.box?.high].map((end) => [...(end ?? [])]), [[-2, 0, -4], [1, 3, 1]]); // prettier-ignore
  layer.set(null);
  assert.equal(layer.box, null);
});

test("P2: marks are left out of drafts; points are as broad on every screen", () => {
  const layer = new MarksLayer();
  layer.view({ ...VIEW, draft: true });
  assert.equal(layer.group.visible, false);
  layer.view(VIEW);
  assert.equal(layer.group.visible, true);
  const { uniforms } = drawn(layer).points.material;
  assert.equal(uniforms.size.value, 16, "8 CSS pixels of two each");
  assert.ok(uniforms.pull.value > 0, "before the surface they lie on");
});

test("R13: what is let go of leaves the index that the surface shares", () => {
  const layer = new MarksLayer();
  layer.set({ ...NONE, faces: Float32Array.from(square(0)), face_colours: Uint8Array.from([0]) });
  const { faces } = drawn(layer);
  let told = false;
  faces.geometry.addEventListener("dispose", () => (told = true));
  layer.dispose();
  assert.equal(told, true);
  assert.equal(faces.geometry.getIndex(), null);
});

test("R13: past the last colour there is the last one", () => {
  assert.equal(markColour(0), MARK_STYLES[0].colour);
  assert.equal(markColour(99), MARK_STYLES[LOST].colour);
});
