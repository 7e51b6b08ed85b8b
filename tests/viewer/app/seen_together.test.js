import assert from "node:assert/strict";
import { test } from "node:test";
import { fileOf } from "./fake_core.js";
import { page, settled } from "./two_sides.js";

/** A page with two meshes. @param {import("./fake_core.js").Body} a @param {import("./fake_core.js").Body} b @param {object} [compare] settings before the second comes */
async function opened(a, b, compare = {}) {
  const all = page();
  await all.app.openFiles([fileOf("a.mesh", a)]);
  all.store.set({ compare });
  await all.comparing.openFiles([fileOf("b.mesh", b)]);
  await settled();
  const [{ core, side, scene }] = all.seconds;
  return { ...all, other: { core, scene, facts: side.facts, store: side.store } };
}

const UNIT = { centre: [0, 0, 0], diagonal: 1 };
const NEAR = { centre: [0.02, 0, 0], diagonal: 1.04 };
const FAR = { centre: [4, 0, 0], diagonal: 2 };

/** @param {Float32Array | null} found @param {number[]} expected */
function near(found, expected) {
  assert.equal(found?.length, expected.length);
  expected.forEach((value, k) => assert.ok(Math.abs((found?.[k] ?? NaN) - value) < 1e-6, `${found}`));
}

test("S6: bodies that are nearly at the same place are seen there; others each in its own frame", async () => {
  const together = await opened(UNIT, NEAR);
  assert.equal(together.facts.get("together"), true);
  const apart = await opened(UNIT, FAR);
  assert.equal(apart.facts.get("together"), false);
  assert.equal(apart.scene.beside, null);
  assert.equal(apart.other.scene.beside, null);
});

test("S6: what is chosen counts more than what fits", async () => {
  assert.equal((await opened(UNIT, NEAR, { camera: "own" })).facts.get("together"), false);
  assert.equal((await opened(UNIT, FAR, { camera: "same" })).facts.get("together"), true);
});

test("S6: at the same place each scene is told of the other's outline, in its own coordinates", async () => {
  const { scene, other } = await opened(UNIT, FAR, { camera: "same" });
  // Outlines reach half a diagonal to both sides: from 3 to 5 of the file, and from -0.5 to 0.5.
  near(scene.beside, [5, 0, 0, 3, 0, 0]);
  near(other.scene.beside, [(0.5 - 4) / 2, 0, 0, (-0.5 - 4) / 2, 0, 0]);
});

test("S6: at the same place a camera sees the same point of both, and else the same part of each", async () => {
  const { store, other } = await opened(UNIT, FAR, { camera: "same" });
  store.set({ camera: { target: [4, 0, 1], distance: 6 } });
  assert.deepEqual(other.store.status.camera.target, [0, 0, 0.5]);
  assert.equal(other.store.status.camera.distance, 3);
  store.set({ compare: { camera: "own" } });
  assert.deepEqual(other.store.status.camera.target, [4, 0, 1]);
  assert.equal(other.store.status.camera.distance, 6);
});

test("S6: a change of the setting, or another mesh, is followed at once", async () => {
  const { app, store, facts, scene, other, comparing } = await opened(UNIT, FAR);
  store.set({ compare: { camera: "same" } });
  assert.deepEqual([facts.get("together"), scene.beside !== null], [true, true]);
  store.set({ compare: { camera: "auto" } });
  assert.deepEqual([facts.get("together"), scene.beside, other.scene.beside], [false, null, null]);
  await comparing.openFiles([fileOf("c.mesh", NEAR)]);
  assert.equal(facts.get("together"), true);
  await app.openFiles([fileOf("d.mesh", FAR)]);
  assert.equal(facts.get("together"), false);
});

test("S6: when the second mesh has gone nothing stands beside the first", async () => {
  const { facts, scene, comparing, app } = await opened(UNIT, NEAR);
  comparing.close();
  assert.equal(scene.beside, null);
  assert.equal(facts.get("together"), false);
  assert.equal(app.look.status, app.store.status);
});

const REACHES = [
  { ...UNIT, cells: "hexes", reach: /** @type {const} */ ([0, 3]) },
  { ...UNIT, cells: "hexes", reach: /** @type {const} */ ([-1, 2]) },
];

test("S6: colours are made for the range of both meshes, and each for its own where that is chosen", async () => {
  const { app, store, other } = await opened(REACHES[0], REACHES[1]);
  assert.deepEqual(app.look.status.colour.reach, [-1, 3]);
  assert.deepEqual(other.store.status.colour.reach, [-1, 3]);
  assert.equal(store.status.colour.reach, null, "it is no setting of the status");
  store.set({ compare: { colours: "own" } });
  assert.equal(app.look.status.colour.reach, null);
  assert.equal(other.store.status.colour.reach, null);
  store.set({ compare: { colours: "common" } });
  assert.deepEqual(other.store.status.colour.reach, [-1, 3]);
});

test("S6: there is no common range before both have theirs, nor when one has none", async () => {
  const { app, store, facts, other } = await opened(REACHES[0], REACHES[1]);
  const theirs = other.facts.get("statistics");
  const reach = () => app.look.status.colour.reach;
  other.facts.set({ statistics: {} });
  assert.equal(reach(), null);
  other.facts.set({ statistics: { scaled_jacobian: /** @type {any} */ ({ min: null, max: null }) } });
  assert.equal(reach(), null, "no value of it is finite");
  other.facts.set({ statistics: theirs });
  assert.deepEqual(reach(), [-1, 3]);
  facts.set({ statistics: {} });
  assert.equal(reach(), null);
  store.set({ colour: { metric: "volume" } });
  assert.equal(reach(), null, "of another quantity nothing is known yet");
  await settled();
  assert.deepEqual(reach(), [-1, 3]);
});

test("S6: both cores are told of the common range, and no longer when the second mesh has gone", async () => {
  const { core, other, comparing } = await opened(REACHES[0], REACHES[1]);
  const told = (/** @type {import("./fake_core.js").Core} */ one) =>
    one
      .questions("update")
      .flatMap(([changed]) => (changed.colour && "reach" in changed.colour ? [changed.colour.reach] : []))
      .at(-1);
  assert.deepEqual([told(core), told(other.core)], [[-1, 3], [-1, 3]]); // prettier-ignore
  comparing.close();
  await settled();
  assert.equal(told(core), null);
});

test("S6: an attribute that the second mesh has not leaves it plain, and its colours are those of the first alone", async () => {
  const { app, store, other, said } = await opened({ ...REACHES[0], attributes: ["cell:heat"] }, REACHES[1]);
  store.set({ colour: { by: "attribute", attribute: "cell:heat" } });
  await settled();
  assert.equal(app.look.status.colour.by, "attribute");
  assert.equal(other.store.status.colour.by, "sides");
  assert.equal(app.look.status.colour.reach, null);
  assert.deepEqual(said(), []);
});

test("S6: quantities of the comparison are both meshes' from when they know of each other", async () => {
  const { app, store, facts, other } = await opened({ ...UNIT, cells: "hexes" }, { ...UNIT, cells: "hexes" });
  store.set({
    colour: { by: "attribute", attribute: "change:volume" },
    arrows: { attribute: "compare:displacement" },
  });
  const drawn = () =>
    [app.look, other.store].map(({ status: { colour, arrows } }) => [colour.attribute, arrows.attribute]);
  const all = ["change:volume", "compare:displacement"];
  assert.deepEqual(drawn(), [all, all]);
  const told = facts.get("comparison");
  facts.set({ comparison: null });
  assert.deepEqual(drawn(), [["", ""], ["", ""]]); // prettier-ignore
  facts.set({ comparison: told && { ...told, same_cells: false } });
  assert.deepEqual(drawn(), [["", ""], ["", ""]]); // prettier-ignore
  store.set({ colour: { attribute: "compare:distance" } });
  assert.deepEqual(
    drawn().map(([attribute]) => attribute),
    ["compare:distance", "compare:distance"],
    "distances need no cells",
  );
});

test("S6: picked cells are shared from when the cells are known to be the same", async () => {
  const { store, facts, other } = await opened({ ...UNIT, cells: "hexes" }, { ...UNIT, cells: "hexes" });
  store.set({ filters: { picking: { hidden: [2] } } });
  assert.deepEqual(other.store.status.filters.picking.hidden, [2]);
  facts.set({ comparison: null });
  assert.deepEqual(other.store.status.filters.picking.hidden, []);
});

test("S6: groups and features that the second mesh has too are hidden there as well", async () => {
  const { store, other } = await opened(UNIT, { ...UNIT, cells: "others" });
  const of = (/** @type {string} */ id) => ({
    id,
    name: id,
    origin: "",
    number: null,
    count: 1,
    colour: null,
  });
  const features = { corners: { groups: [] }, edges: { groups: [of("reference:1")] }, faces: { groups: [] } };
  other.facts.set({
    description: /** @type {any} */ ({ groups: [of("elset:A"), of("nset:N")], features }),
  });
  store.set({
    filters: { groups: { hidden: ["elset:A", "elset:B"] } },
    marks: { hidden: ["edges:reference:1", "faces:reference:1"], nodes: ["nset:M", "nset:N"] },
  });
  const { filters, marks } = other.store.status;
  assert.deepEqual(filters.groups.hidden, ["elset:A"]);
  assert.deepEqual(marks.hidden, ["edges:reference:1"]);
  assert.deepEqual(marks.nodes, ["nset:N"]);
});

test("S6: a range that is known of both already is common to them at once", async () => {
  const { app, store, facts, other } = await opened(REACHES[0], REACHES[1]);
  for (const side of [facts, other.facts]) {
    const volume = /** @type {any} */ ({ min: -9, max: side === facts ? 5 : 9, percentiles: {} });
    side.set({ statistics: { ...side.get("statistics"), volume } });
  }
  store.set({ colour: { metric: "volume" } });
  assert.deepEqual(app.look.status.colour.reach, [-9, 9]);
});

test("S6: what comes out of a structure is every mesh's own", async () => {
  const { store, other } = await opened(UNIT, UNIT);
  store.set({ colour: { by: "attribute", attribute: "structure:block" } });
  assert.equal(other.store.status.colour.attribute, "structure:block");
});

test("S6: what is known of metrics is known yet when another comparison begins", async () => {
  const { facts, core, other, comparing } = await opened(UNIT, UNIT, { colours: "own" });
  const [known, asked] = [facts.get("histogram"), core.questions("histogram").length];
  comparing.close();
  await settled();
  await comparing.openFiles([fileOf("c.stl", { surface: true })]);
  await settled();
  assert.equal(facts.get("histogram"), known);
  assert.equal(core.questions("histogram").length, asked);
  assert.equal(other.core.closed, true);
});
