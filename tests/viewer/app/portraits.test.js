import assert from "node:assert/strict";
import { afterEach, beforeEach, test } from "node:test";
import { fileOf } from "./fake_core.js";
import { page, settled } from "./two_sides.js";

/** What of a browser decodes a picture. */
const DECODING = {
  Image: class {
    naturalWidth = 3;
    naturalHeight = 2;
    async decode() {}
  },
  OffscreenCanvas: class {
    getContext() {
      return { drawImage() {}, getImageData: () => ({ data: new Uint8Array(24), width: 3, height: 2 }) };
    }
  },
};
const before = Object.fromEntries(Object.keys(DECODING).map((name) => [name, Reflect.get(globalThis, name)]));
beforeEach(() => void Object.assign(globalThis, DECODING));
afterEach(() => void Object.assign(globalThis, before));

const SOURCE = { slug: "far", title: "Far", authors: ["A. One"], year: 2020, meshes: [] };

/** A page whose catalogue has one mesh, which comes, or does not, when that is said. @param {object} [row] */
function waiting(row = { picture: "pictures/far/duck.webp" }) {
  const all = page({ alone: true });
  const mesh = { slug: "duck", name: "Duck", cells: 8, url: "duck.mesh", remote: true, ...row };
  const catalogue = { entry: () => ({ source: SOURCE, mesh }) };
  all.app.catalogue = /** @type {any} */ (Promise.resolve(catalogue));
  const asked = /** @type {string[]} */ ([]);
  Object.assign(all.app.ahead, {
    bytes: async (/** @type {string} */ address) => (asked.push(address), new ArrayBuffer(4)),
  });
  let come = () => {};
  let fail = () => {};
  const file = fileOf("duck.mesh").arrayBuffer();
  const bytes = /** @type {Promise<ArrayBuffer>} */ (
    new Promise((resolve, reject) => {
      come = () => resolve(file);
      fail = () => reject(new Error("there is no network"));
    })
  );
  all.app.fetching.from = (address) => ({ name: "duck.mesh", address, bytes: () => bytes });
  const ask = async (/** @type {unknown} */ status = undefined) => {
    const opening = all.app.openEntry("far", "duck", status);
    opening.catch(() => {});
    await settled();
  };
  const portrait = () => all.facts.get("portrait");
  return { ...all, asked, ask, come: () => (come(), settled()), fail: () => (fail(), settled()), portrait };
}

test("C8: the portrait stands in for a mesh that is fetched, until that is drawn", async () => {
  const all = waiting();
  await all.ask();
  assert.equal(all.portrait()?.aside, false);
  assert.match(all.portrait()?.image.alt ?? "", /Duck.*A\. One/);
  assert.equal(all.facts.get("summary"), null);
  await all.come();
  assert.equal(all.facts.get("summary")?.name, "duck.mesh");
  assert.equal(all.portrait(), null);
});

test("C8: the settings are the portrait's already: what is changed while it stands goes on from them", async () => {
  const view = { camera: { direction: [1, 0, 0], up: [0, 0, 1] }, separation: { mode: "rounded" } };
  const all = waiting({ picture: "duck.webp", view });
  await all.ask();
  assert.deepEqual(all.store.status.camera.direction, [1, 0, 0]);
  assert.equal(all.store.canUndo, false);
  all.store.set({ filters: { peel: { depth: 1 } } });
  await all.come();
  const { camera, filters, separation } = all.store.status;
  assert.deepEqual([camera.direction, filters.peel.depth, separation.mode], [[1, 0, 0], 1, "rounded"]);
});

test("C8: going, a portrait moves to where the mesh is, unless the mesh is seen otherwise by then", async () => {
  for (const fit of [true, false]) {
    const all = waiting();
    all.facts.set({ canvas: { width: 900, height: 700 } });
    await all.ask();
    const sizes = /** @type {unknown[]} */ ([]);
    all.facts.on("portrait", (portrait) => sizes.push(portrait && portrait.size));
    if (!fit) all.store.set({ camera: { fit } });
    await all.come();
    assert.equal(sizes.pop(), null);
    assert.equal(sizes.length, fit ? 1 : 0);
    for (const { width, height } of /** @type {{ width: number, height: number }[]} */ (sizes))
      assert.ok(width > 300 && height > 200, `${width} x ${height}`);
  }
});

test("C8: a mesh that can't be had leaves its portrait, and the message", async () => {
  const all = waiting();
  await all.ask();
  await all.fail();
  assert.equal(all.portrait()?.entry.mesh.name, "Duck");
  assert.deepEqual(all.said(), [["error", "there is no network"]]);
  await all.app.openFiles([fileOf("own.mesh")]);
  assert.equal(all.portrait(), null, "another mesh takes its place");
});

test("C8: an open mesh stays until the new one is there, whose portrait stands aside", async () => {
  for (const end of /** @type {const} */ (["come", "fail"])) {
    const all = waiting();
    await all.app.openFiles([fileOf("own.mesh")]);
    await all.ask();
    assert.equal(all.portrait()?.aside, true);
    assert.equal(all.facts.get("summary")?.name, "own.mesh");
    await all[end]();
    assert.equal(all.portrait(), null);
    assert.equal(all.facts.get("summary")?.name, end === "come" ? "duck.mesh" : "own.mesh");
  }
});

test("C8: another mesh that is asked for takes the portrait away", async () => {
  const all = waiting();
  await all.ask();
  await all.app.openFiles([fileOf("own.mesh")]);
  await all.come();
  assert.equal(all.portrait(), null);
  assert.equal(all.facts.get("summary")?.name, "own.mesh");
});

test("C8: where the mesh will open under another view, nothing else is promised", async () => {
  const linked = waiting();
  await linked.ask({ filters: { peel: { depth: 1 } } });
  assert.equal(linked.portrait(), null);
  const changed = waiting();
  changed.store.set({ camera: { direction: [1, 0, 0] } });
  await changed.ask();
  assert.equal(changed.portrait(), null);
});

test("O2: what has a preview, or no picture, has no portrait", async () => {
  for (const row of [{ picture: "duck.webp", preview: "duck.preview" }, {}]) {
    const all = waiting(row);
    await all.ask();
    assert.equal(all.portrait(), null);
    assert.deepEqual(all.asked, []);
  }
});
