import assert from "node:assert/strict";
import { test } from "node:test";
import { isolate } from "../../../static/viewer/state/picking.js";
import { SecondStore } from "../../../static/viewer/state/second_store.js";
import { StatusStore } from "../../../static/viewer/state/store.js";
import { DEFAULTS } from "../defaults.js";

/** Both stores, of which the second has told what it has. @param {boolean} same whether the cells are */
function parts(same) {
  const first = new StatusStore(DEFAULTS);
  first.set({ mesh: { name: "a.mesh", sha256: "aa", cells: 100 } }, { undo: false });
  const second = new SecondStore(first);
  second.know({ same, cells: 10, has: () => true, groups: () => true });
  const heard = /** @type {any[]} */ ([]);
  const hear = (/** @type {string} */ path) =>
    second.on(path, (status, changed) => heard.push({ path, changed: [...changed], status }));
  return { first, second, heard, hear };
}

test("S6: a second store reads the one status, with the second mesh's name", () => {
  const { first, second } = parts(true);
  first.set({ compare: { other: { name: "b.mesh", cells: 10 } }, filters: { peel: { depth: 3 } } });
  assert.equal(second.status.filters.peel.depth, 3);
  assert.equal(second.status.mesh.name, "b.mesh");
  assert.equal(second.valueAt("mesh.name"), "b.mesh");
  assert.equal(second.valueAt("filters.peel.depth"), 3);
  assert.equal(first.valueAt("mesh.name"), "a.mesh");
  assert.deepEqual(second.defaults, first.defaults);
  assert.equal(second.defaultAt("camera.distance"), DEFAULTS.camera.distance);
});

test("S6: before anything is known of the second mesh nothing is taken to be that of the first", () => {
  const first = new StatusStore(DEFAULTS);
  const second = new SecondStore(first);
  first.set({
    colour: { by: "attribute", attribute: "cell:heat" },
    filters: { picking: isolate([3]), groups: { hidden: ["elset:A"] } },
    camera: { distance: 7 },
  });
  const { colour, filters, camera } = second.status;
  assert.deepEqual([colour.by, colour.reach], ["sides", null]);
  assert.deepEqual(filters, DEFAULTS.filters);
  assert.equal(camera.distance, 7);
});

test("S6: what is set at the second is set in the one status, by paths as well", () => {
  const { first, second } = parts(false);
  second.set({ filters: { picking: isolate([4, 2]) } });
  second.setAt("filters.peel.depth", 2);
  second.setAt("filters.picking.hidden", [5]);
  assert.deepEqual(first.status.compare.picking, { isolated: true, hidden: [5], shown: [2, 4] });
  assert.deepEqual(first.status.filters.picking, DEFAULTS.filters.picking);
  assert.equal(first.status.filters.peel.depth, 2);
  assert.deepEqual(second.valueAt("filters.picking.hidden"), [5]);
});

test("S6: a path into a list is replaced in a copy of the list that is there", () => {
  const { first, second } = parts(true);
  second.setAt("filters.planes.items.0.offset", 0.25);
  assert.deepEqual(first.status.filters.planes.items, [{ enabled: true, normal: [1, 0, 0], offset: 0.25 }]);
});

test("S6: its listeners hear of what changes for the second mesh, in its own settings", () => {
  const { first, second, hear, heard } = parts(false);
  hear("filters.picking");
  first.set({ filters: { picking: isolate([3]) } });
  assert.equal(heard.length, 0, "the first one's picks are none of other cells");
  second.set({ filters: { picking: isolate([3]) } });
  assert.equal(heard.length, 1);
  const own = heard[0].changed.filter((/** @type {string} */ path) => !path.startsWith("compare."));
  assert.deepEqual(own, ["filters.picking.isolated", "filters.picking.shown"]);
  assert.deepEqual(heard[0].status.filters.picking.shown, [3]);
});

test("S6: what is known anew of the second mesh changes what it reads, and its listeners are told", () => {
  const { first, second, hear, heard } = parts(false);
  first.set({ filters: { picking: isolate([3]) }, camera: { target: [1, 0, 0], distance: 4 } });
  hear("*");
  second.know({ same: true });
  assert.deepEqual(heard.splice(0)[0].changed.sort(), ["filters.picking.isolated", "filters.picking.shown"]);
  const frames = { first: { centre: [0, 0, 0], diagonal: 1 }, second: { centre: [2, 0, 0], diagonal: 2 } };
  second.know({ frames });
  assert.deepEqual(heard.splice(0)[0].changed.sort(), ["camera.distance", "camera.target"]);
  assert.deepEqual(second.status.filters.picking.shown, [3], "what was known before is known yet");
  second.know({ reach: [0, 5] });
  assert.deepEqual(heard.splice(0)[0].changed, ["colour.reach"]);
  second.know({ reach: [0, 5] });
  assert.deepEqual(heard, []);
});

test("S6: a camera that is moved at the second one moves both, each in its own frame", () => {
  const { first, second } = parts(true);
  second.know({
    frames: { first: { centre: [0, 0, 0], diagonal: 1 }, second: { centre: [2, 0, 0], diagonal: 2 } },
  });
  second.set({ camera: { target: [-0.5, 0, 0], distance: 2, fit: false } }, { undo: "camera" });
  assert.deepEqual(first.status.camera.target, [1, 0, 0]);
  assert.equal(first.status.camera.distance, 4);
  assert.deepEqual(second.status.camera.target, [-0.5, 0, 0]);
});

test("S2: there is one history: a step at the second is undone and redone at either", () => {
  const { first, second } = parts(false);
  second.set({ filters: { picking: isolate([4]) } });
  first.set({ filters: { peel: { depth: 1 } } });
  assert.equal(second.undo(), true);
  assert.equal(first.status.filters.peel.depth, 0);
  assert.equal(first.undo(), true);
  assert.deepEqual(second.status.filters.picking, DEFAULTS.filters.picking);
  assert.equal(second.undo(), false);
  assert.equal(second.redo(), true);
  assert.deepEqual(second.status.filters.picking.shown, [4]);
});

test("S2: changes under one key are one step at the second too, until sealed", () => {
  const { first, second } = parts(true);
  for (const distance of [2, 3]) second.set({ camera: { distance } }, { undo: "camera" });
  second.seal();
  second.set({ camera: { distance: 4 } }, { undo: "camera" });
  second.set({ mesh: { name: "b.mesh" } }, { undo: false });
  first.undo();
  assert.equal(second.status.camera.distance, 3);
  first.undo();
  assert.equal(second.status.camera.distance, DEFAULTS.camera.distance);
  assert.equal(first.canUndo, false);
});

test("S6: a store that is stopped tells nothing any more", () => {
  const { first, second, hear, heard } = parts(true);
  hear("*");
  second.stop();
  first.set({ camera: { distance: 9 } });
  assert.deepEqual(heard, []);
});
