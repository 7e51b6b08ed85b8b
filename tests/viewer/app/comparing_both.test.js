import assert from "node:assert/strict";
import { test } from "node:test";
import { DEFAULTS } from "../defaults.js";
import { fileOf } from "./fake_core.js";
import { page, settled } from "./two_sides.js";

/** A page with two meshes. @param {import("./fake_core.js").Body} [a] @param {import("./fake_core.js").Body} [b] */
async function opened(a = { cells: "hexes" }, b = { cells: "hexes" }) {
  const all = page();
  await all.app.openFiles([fileOf("a.mesh", a)]);
  await all.comparing.openFiles([fileOf("b.mesh", b)]);
  await settled();
  return all;
}

const FIRST = { enabled: true, isolated: false, hidden: [1, 7], shown: [] };
const SECOND = { isolated: true, hidden: [], shown: [2] };

for (const count of [8, 3])
  test(`S6: both change places, and cells that were picked go with their mesh, of 8 and ${count} other cells`, async () => {
    const all = await opened({ cells: "hexes" }, { cells: "others", count });
    all.store.set({ filters: { picking: FIRST }, compare: { picking: SECOND }, colour: { map: "jet" } });
    await all.comparing.swap();
    await settled();
    const { core, seconds, facts, store } = all;
    assert.deepEqual([core.mesh?.name, seconds[0].core.mesh?.name], ["b.mesh", "a.mesh"]);
    assert.deepEqual([core.compared, seconds[0].core.compared], ["a.mesh", "b.mesh"]);
    assert.equal(facts.get("comparison")?.name, "a.mesh");
    assert.deepEqual([store.status.mesh.name, store.status.compare.other.name], ["b.mesh", "a.mesh"]);
    const { enabled: _, ...first } = FIRST;
    assert.deepEqual(store.status.filters.picking, { enabled: true, ...SECOND });
    assert.deepEqual(store.status.compare.picking, first);
    assert.deepEqual(seconds[0].side.store.status.filters.picking, FIRST);
    assert.equal(store.status.colour.map, "jet", "all other settings stay");
    assert.equal(store.canUndo, false);
    assert.deepEqual(all.said(), []);
  });

test("S6: of the same cells the picked ones stay where they are, and twice swapped is as before", async () => {
  const all = await opened();
  all.store.set({ filters: { picking: FIRST } });
  const before = all.store.status;
  await all.comparing.swap();
  await settled();
  assert.deepEqual(all.store.status.filters.picking, FIRST);
  assert.deepEqual(all.store.status.compare.picking, DEFAULTS.compare.picking);
  await all.comparing.swap();
  await settled();
  assert.deepEqual(all.store.status, before);
});

test("S6: what shows quantities of the comparison stays when both change places", async () => {
  const all = await opened({ cells: "hexes", attributes: ["cell:heat"] });
  const items = /** @type {const} */ ([
    { quantity: "change:volume", keep: "outside", minimum: 0, maximum: null },
  ]);
  all.store.set({
    colour: { by: "attribute", attribute: "change:volume", map: "diverging", range: [-1, 1] },
    arrows: { attribute: "compare:displacement" },
    filters: { quality: { items } },
  });
  await settled();
  const { colour, arrows, filters } = all.store.status;
  await all.comparing.swap();
  await settled();
  assert.deepEqual(all.store.status.colour, colour);
  assert.deepEqual(all.store.status.arrows, arrows);
  assert.deepEqual(all.store.status.filters, filters);
  assert.equal(all.app.look.status.colour.attribute, "change:volume");
  assert.deepEqual(all.said(), []);
});

test("S6: what fails while both change places is said, and the cells that were picked stay with their places", async () => {
  const all = await opened({ cells: "hexes" }, { cells: "others" });
  all.store.set({ filters: { picking: FIRST }, compare: { picking: SECOND } });
  all.core.fails.open = new Error("out of memory");
  await all.comparing.swap();
  await settled();
  assert.deepEqual(all.said(), [["error", "out of memory"]]);
  assert.deepEqual(all.store.status.filters.picking, FIRST);
});

test("S6: both change places in the page's address, and a step back opens the one that is the first then", async () => {
  const all = await opened();
  /** @type {() => Promise<unknown>} */
  let again = () => Promise.resolve();
  all.app.steps.swap = (open) => void (again = open);
  await all.comparing.swap();
  await settled();
  await all.app.openFiles([fileOf("c.mesh")]);
  await again();
  assert.equal(all.core.mesh?.name, "b.mesh");
});

test("S6: without a second mesh nothing changes places", async () => {
  const all = page();
  await all.app.openFiles([fileOf("a.mesh")]);
  const before = all.store.status;
  await all.comparing.swap();
  assert.equal(all.store.status, before);
  await all.comparing.openFiles([fileOf("b.stl", { surface: true })]);
  await all.comparing.swap();
  assert.equal(all.core.mesh?.name, "a.mesh");
});

test("S6: statistics of a quantity are asked of both, and of neither twice", async () => {
  const all = await opened();
  await all.comparing.measure("volume");
  await all.comparing.measure("volume");
  for (const core of [all.core, all.seconds[0].core])
    assert.equal(core.questions("quality").filter(([id]) => id === "volume").length, 1);
  const of = (/** @type {any} */ facts) => facts.get("statistics").volume.of;
  assert.equal(of(all.facts), "volume of a.mesh and b.mesh");
  assert.equal(of(all.seconds[0].side.facts), "volume of b.mesh and a.mesh");
});

test("S6: changes are asked of the first where the cells are the same, and an error is said", async () => {
  const all = await opened();
  Object.assign(all.core, { _metric_changes: (/** @type {string} */ metric) => ({ metric, worse: 2 }) });
  assert.deepEqual(await all.comparing.changes("volume"), { metric: "volume", worse: 2 });
  all.core.fails.metric_changes = new Error("out of memory");
  assert.equal(await all.comparing.changes("volume"), null);
  assert.deepEqual(all.said(), [["error", "out of memory"]]);
  const others = await opened({ cells: "hexes" }, { cells: "others" });
  assert.equal(await others.comparing.changes("volume"), null);
  assert.equal(others.core.questions("metric_changes").length, 0);
});

test("S6: memory is told of each core that there is", async () => {
  const all = await opened();
  all.core.memory = 5;
  all.seconds[0].core.memory = 7;
  assert.deepEqual(all.comparing.memory, [5, 7]);
  all.comparing.close();
  assert.deepEqual(all.comparing.memory, [5]);
});

test("S6: what was known of a change from one mesh to another is not told of the next one", async () => {
  const all = await opened();
  all.store.set({ colour: { by: "attribute", attribute: "change:volume" } });
  await settled();
  const known = (/** @type {any} */ facts) => {
    const { "change:volume": statistics } = facts.get("statistics");
    return [statistics?.of, facts.get("histogram")?.of, facts.get("worst")?.of];
  };
  assert.deepEqual(known(all.facts), Array(3).fill("change:volume of a.mesh and b.mesh"));
  await all.comparing.openFiles([fileOf("c.mesh", { cells: "hexes" })]);
  await settled();
  assert.deepEqual(known(all.facts), Array(3).fill("change:volume of a.mesh and c.mesh"));
  await all.app.openFiles([fileOf("d.mesh", { cells: "hexes" })]);
  await settled();
  assert.deepEqual(known(all.facts), Array(3).fill("change:volume of d.mesh and c.mesh"));
  assert.deepEqual(known(all.seconds[0].side.facts), Array(3).fill("change:volume of c.mesh and d.mesh"));
});

test("S6: colours by a change are plain while the cells are others, and come back where they are the same", async () => {
  const all = await opened();
  all.store.set({ colour: { by: "attribute", attribute: "change:volume" } });
  await settled();
  assert.equal(all.app.look.status.colour.by, "attribute");
  await all.comparing.openFiles([fileOf("c.mesh", { cells: "others" })]);
  await settled();
  assert.equal(all.app.look.status.colour.by, "sides");
  assert.equal(all.seconds[0].side.store.status.colour.by, "sides");
  assert.equal(all.store.status.colour.attribute, "change:volume", "the setting waits");
  await all.comparing.openFiles([fileOf("d.mesh", { cells: "hexes" })]);
  await settled();
  assert.equal(all.app.look.status.colour.attribute, "change:volume");
  assert.equal(all.seconds[0].side.store.status.colour.attribute, "change:volume");
  assert.deepEqual(all.said(), [], "no core was asked for what it does not know");
});

test("S6: the structure is traced of both", async () => {
  const all = await opened();
  const facts = { sheets: 3 };
  for (const core of [all.core, all.seconds[0].core])
    Object.assign(core, { _trace: () => ({ next: null }), _structure_facts: () => facts });
  await all.comparing.trace();
  assert.equal(all.facts.get("structure"), facts);
  assert.equal(all.seconds[0].side.facts.get("structure"), facts);
});

test("S6: both are drawn when they know of each other, and what was measured of others goes", async () => {
  const all = page();
  all.store.set({ compare: { colours: "own" } });
  await all.app.openFiles([fileOf("a.mesh", { cells: "hexes" })]);
  await all.comparing.openFiles([fileOf("b.mesh", { cells: "hexes" })]);
  await settled();
  for (const { asked } of [all.core, all.seconds[0].core]) {
    const methods = asked.map(([method]) => method);
    assert.ok(methods.lastIndexOf("update") > methods.indexOf("compare_with"));
  }
  all.facts.set({ apart: /** @type {any} */ ({ hausdorff: 1 }) });
  await all.comparing.openFiles([fileOf("c.mesh")]);
  assert.equal(all.facts.get("apart"), null);
});

test("S6: what keeps two meshes from knowing of each other is said, and both stay", async () => {
  const all = await opened();
  all.core.fails.hand_over = new Error("out of memory");
  await all.comparing.openFiles([fileOf("c.mesh")]);
  await settled();
  assert.deepEqual(all.said(), [["error", "out of memory"]]);
  assert.equal(all.facts.get("comparison"), null);
  assert.equal(all.facts.get("second")?.get("summary")?.name, "c.mesh");
});

test("S6: what two meshes tell of each other is told no more when the second has gone meanwhile", async () => {
  const all = await opened();
  let tell = () => {};
  all.core.waits.compare_with = new Promise((resolve) => (tell = () => resolve(null)));
  await all.comparing.openFiles([fileOf("c.mesh")]);
  await new Promise((resolve) => setTimeout(resolve, 20));
  all.comparing.close();
  tell();
  await settled();
  assert.equal(all.facts.get("comparison"), null);
  assert.equal(all.core.compared, null);
  assert.deepEqual(all.said(), []);
});
