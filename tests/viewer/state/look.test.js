import assert from "node:assert/strict";
import { test } from "node:test";
import { Look } from "../../../static/viewer/state/look.js";
import { StatusStore } from "../../../static/viewer/state/store.js";

const BEFORE = {
  camera: { distance: 1.5, direction: [0, 0, -1] },
  colour: { by: "sides", reach: /** @type {number[] | null} */ (null) },
  filters: { peel: { depth: 0 }, picking: { hidden: /** @type {number[]} */ ([]) } },
};

/** A store, and a look at it whose colours are made for a range. */
function parts() {
  const store = /** @type {StatusStore<any>} */ (new StatusStore(BEFORE));
  const look = new Look(store);
  const heard = /** @type {any[][]} */ ([]);
  const hear = (/** @type {string} */ path) =>
    look.on(path, (status, changed) => heard.push([path, [...changed], status]));
  return { store, look, heard, hear, paths: () => heard.splice(0).map(([path, changed]) => [path, changed]) };
}

/** @param {number[] | null} reach @returns {(status: any) => any} */
const reaching = (reach) => (status) => ({ ...status, colour: { ...status.colour, reach } });

test("S6: a look is the status itself until it is made of more", () => {
  const { store, look, hear, paths } = parts();
  assert.equal(look.status, store.status);
  hear("*");
  store.set({ filters: { peel: { depth: 2 } } });
  assert.equal(look.status, store.status);
  assert.deepEqual(paths(), [["*", ["filters.peel.depth"]]]);
});

test("S6: what it is made of tells what has changed by that, and the status stays as it is", () => {
  const { store, look, hear, heard, paths } = parts();
  const before = store.status;
  hear("*");
  look.derive(reaching([0, 3]));
  assert.deepEqual(look.status.colour.reach, [0, 3]);
  assert.equal(store.status, before);
  assert.equal(store.canUndo, false);
  assert.equal(heard[0][2], look.status, "listeners are given what it is now");
  assert.deepEqual(paths(), [["*", ["colour.reach"]]]);
});

test("S6: a change of the status that makes no other look tells nobody", () => {
  const { store, look, hear, paths } = parts();
  look.derive((status) => ({ ...status, colour: { ...status.colour, by: "sides" } }));
  hear("*");
  store.set({ colour: { by: "quality" } });
  assert.deepEqual(paths(), []);
  assert.equal(look.status.colour.by, "sides");
  store.set({ colour: { by: "kind" }, camera: { distance: 2 } });
  assert.deepEqual(paths(), [["*", ["camera.distance"]]]);
});

test("S6: renewed, it tells only what has changed, and nothing where that is nothing", () => {
  const { look, hear, paths } = parts();
  let reach = [0, 1];
  look.derive((status) => reaching([...reach])(status));
  hear("*");
  look.renew();
  assert.deepEqual(paths(), [], "a new list of the same numbers is no change");
  reach = [0, 2];
  look.renew();
  assert.deepEqual(paths(), [["*", ["colour.reach"]]]);
  look.renew();
  assert.deepEqual(paths(), []);
});

test("S6: it is frozen as every status is", () => {
  const { look } = parts();
  look.derive(reaching([0, 1]));
  const { colour, filters } = /** @type {any} */ (look.status);
  assert.throws(() => colour.reach.push(2), TypeError);
  assert.throws(() => (filters.peel.depth = 4), TypeError);
});

test("S6: listeners hear of changes at, above and below their path, and of no others", () => {
  const { store, look, hear, paths } = parts();
  for (const path of ["filters", "filters.peel.depth", "filters.picking", "colour", "camera"]) hear(path);
  store.set({ filters: { peel: { depth: 1 } } });
  assert.deepEqual(
    paths().map(([path]) => path),
    ["filters", "filters.peel.depth"],
  );
  look.derive(reaching([1, 2]));
  assert.deepEqual(
    paths().map(([path]) => path),
    ["colour"],
  );
});

test("S6: a listener that was taken off hears nothing, and those beside it do", () => {
  const { store, hear, paths } = parts();
  const stop = hear("camera");
  hear("camera.distance");
  stop();
  store.set({ camera: { distance: 9 } });
  assert.deepEqual(
    paths().map(([path]) => path),
    ["camera.distance"],
  );
});

test("S6: one that takes itself off while it is told does not keep the others from being told", () => {
  const { store, look } = parts();
  const heard = /** @type {string[]} */ ([]);
  const stop = look.on("*", () => {
    heard.push("once");
    stop();
  });
  look.on("*", () => heard.push("always"));
  store.set({ camera: { distance: 2 } });
  store.set({ camera: { distance: 3 } });
  assert.deepEqual(heard, ["once", "always", "always"]);
});

test("S6: stopped, it follows the status no more", () => {
  const { store, look, hear, paths } = parts();
  hear("*");
  look.stop();
  const before = look.status;
  store.set({ camera: { distance: 7 } });
  assert.deepEqual(paths(), []);
  assert.equal(look.status, before);
  look.renew();
  assert.deepEqual(paths(), [], "and tells nobody, though it is renewed once more");
});
