import assert from "node:assert/strict";
import { test } from "node:test";
import { StatusStore } from "../../../static/viewer/state/store.js";

const DEFAULTS = {
  version: 1,
  mesh: { name: "", cells: 0 },
  camera: { direction: [0, 0, -1], distance: 1.5 },
  filters: {
    peel: { enabled: true, depth: 0 },
    planes: { items: [{ enabled: true, normal: [1, 0, 0], offset: 0 }] },
  },
};

const store = () => new StatusStore(DEFAULTS);

test("S1: a partial document changes what it holds and nothing else", () => {
  const one = store();
  const before = one.status;
  assert.deepEqual(one.set({ filters: { peel: { depth: 2 } } }), ["filters.peel.depth"]);
  assert.equal(one.status.filters.peel.depth, 2);
  assert.equal(one.status.filters.peel.enabled, true);
  assert.equal(one.status.camera, before.camera, "what stays keeps its identity");
  assert.equal(before.filters.peel.depth, 0, "the document before is not touched");
});

test("S1: documents are frozen, down to the arrays", () => {
  const one = store();
  one.set({ camera: { direction: [1, 0, 0] } });
  assert.throws(() => (one.status.filters.peel.depth = 9), TypeError);
  assert.throws(() => one.status.camera.direction.push(1), TypeError);
});

test("S1: what a caller does to its own document later has no effect", () => {
  const one = store();
  const partial = { camera: { direction: [1, 0, 0] } };
  one.set(partial);
  partial.camera.direction[0] = 5;
  assert.deepEqual(one.status.camera.direction, [1, 0, 0]);
});

test("S1: a change to the same values is no change, tells nobody and is no step", () => {
  const one = store();
  let told = 0;
  one.on("*", () => told++);
  assert.deepEqual(one.set({ camera: { direction: [0, 0, -1] } }), []);
  assert.equal(told, 0);
  assert.equal(one.canUndo, false);
});

test("listeners hear of changes at, above and below their path", () => {
  const one = store();
  /** @type {string[]} */
  const heard = [];
  for (const path of [
    "*",
    "filters",
    "filters.peel",
    "filters.peel.depth",
    "camera",
    "filters.planes.items.0.offset",
  ]) {
    one.on(path, () => heard.push(path));
  }
  one.setAt("filters.peel.depth", 1);
  assert.deepEqual(heard.splice(0), ["*", "filters", "filters.peel", "filters.peel.depth"]);
  one.setAt("filters.planes.items.0.offset", 0.5);
  assert.deepEqual(heard.splice(0), ["*", "filters", "filters.planes.items.0.offset"]);
});

test("a listener that was taken off hears nothing", () => {
  const one = store();
  let told = 0;
  one.on("camera", () => told++)();
  one.set({ camera: { distance: 2 } });
  assert.equal(told, 0);
});

test("a path into an array replaces that value in a copy of the array", () => {
  const one = store();
  const before = one.status.filters.planes.items;
  one.setAt("filters.planes.items.0.offset", 0.25);
  assert.deepEqual(one.status.filters.planes.items, [{ enabled: true, normal: [1, 0, 0], offset: 0.25 }]);
  assert.equal(before[0].offset, 0);
});

test("S2: undo and redo go through every change", () => {
  const one = store();
  one.set({ filters: { peel: { depth: 1 } } });
  one.set({ camera: { distance: 3 } });
  const last = one.status;
  assert.equal(one.undo(), true);
  assert.equal(one.status.camera.distance, 1.5);
  assert.equal(one.undo(), true);
  assert.deepEqual(one.status, DEFAULTS);
  assert.equal(one.undo(), false);
  one.redo();
  one.redo();
  assert.deepEqual(one.status, last);
  assert.equal(one.redo(), false);
});

test("S2: changes under one key are one step, until sealed or interrupted", () => {
  const one = store();
  for (const depth of [1, 2, 3]) one.set({ filters: { peel: { depth } } }, { undo: "peel" });
  one.seal();
  for (const depth of [4, 5]) one.set({ filters: { peel: { depth } } }, { undo: "peel" });
  one.set({ camera: { distance: 2 } }, { undo: "camera" });
  one.set({ filters: { peel: { depth: 6 } } }, { undo: "peel" });
  const depths = [];
  while (one.undo()) depths.push(one.status.filters.peel.depth);
  assert.deepEqual(depths, [5, 5, 3, 0]);
});

test("S2: a new change after an undo forgets what could be redone", () => {
  const one = store();
  one.setAt("filters.peel.depth", 1);
  one.undo();
  one.setAt("filters.peel.depth", 2);
  assert.equal(one.canRedo, false);
});

test("S2: the mesh's identity is not undone, and forget() empties the history", () => {
  const one = store();
  one.setAt("filters.peel.depth", 1);
  one.set({ mesh: { name: "cube.mesh", cells: 8 } }, { undo: false });
  one.undo();
  assert.deepEqual(one.status.mesh, { name: "cube.mesh", cells: 8 });
  one.forget();
  assert.equal(one.canRedo, false);
});

test("O1: steps outlive a page that is loaded again", () => {
  const before = store();
  before.set({ filters: { peel: { depth: 1 } } });
  before.set({ filters: { peel: { depth: 2 } } });
  before.set({ filters: { peel: { depth: 3 } } });
  before.undo();
  const held = structuredClone({ status: before.status, history: before.history });
  const after = store();
  after.set(held.status);
  after.recall(held.history);
  assert.equal(after.undo(), true);
  assert.equal(after.status.filters.peel.depth, 1);
  assert.equal(after.redo() && after.redo(), true);
  assert.equal(after.status.filters.peel.depth, 3);
  assert.throws(() => (after.status.filters.peel.depth = 9), TypeError);
});
