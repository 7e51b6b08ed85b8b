import assert from "node:assert/strict";
import { test } from "node:test";
import { DEFAULTS } from "../defaults.js";
import { fileOf } from "./fake_core.js";
import { page, settled } from "./two_sides.js";

/** A page with a mesh, and another beside it. @param {import("./fake_core.js").Body} [a] @param {import("./fake_core.js").Body | null} [b] */
async function opened(a = { cells: "hexes" }, b = { cells: "hexes" }) {
  const all = page();
  await all.app.openFiles([fileOf("a.mesh", a)]);
  if (b) await all.comparing.openFiles([fileOf("b.mesh", b)]);
  await settled();
  return all;
}

/** @param {Awaited<ReturnType<typeof opened>>} all what is open, as the cores and the page have it */
const present = ({ core, seconds, facts, store }) => ({
  cores: [core.mesh?.name, seconds.at(-1)?.core.mesh?.name],
  compared: [core.compared, seconds.at(-1)?.core.compared],
  told: facts.get("comparison")?.name,
  named: store.status.compare.other.name,
});

const BOTH = { cores: ["a.mesh", "b.mesh"], compared: ["b.mesh", "a.mesh"], told: "b.mesh", named: "b.mesh" };

test("S6: a second mesh stands beside the first, and each core knows of the other's", async () => {
  const all = await opened();
  assert.deepEqual(present(all), BOTH);
  assert.equal(all.facts.get("second")?.get("summary")?.name, "b.mesh");
  assert.equal(all.comparing.second, all.seconds[0].side);
  assert.deepEqual(all.store.status.mesh, { name: "a.mesh", cells: 8, sha256: "hash of a.mesh" });
  assert.equal(all.store.canUndo, false, "it is no step that could be undone");
  assert.deepEqual(all.said(), []);
});

test("S6: the next one takes its place in the same view, and is compared in its turn", async () => {
  const all = await opened();
  await all.comparing.openFiles([fileOf("c.mesh", { cells: "others" })]);
  await all.comparing.matched;
  assert.equal(all.seconds.length, 1);
  assert.deepEqual(present(all).compared, ["c.mesh", "a.mesh"]);
  assert.equal(all.facts.get("comparison")?.same_cells, false);
});

test("S6: another first mesh is compared with the second that stays", async () => {
  const all = await opened();
  await all.app.openFiles([fileOf("c.mesh", { cells: "hexes" })]);
  await settled();
  assert.deepEqual(present(all).compared, ["b.mesh", "c.mesh"]);
  assert.equal(all.facts.get("comparison")?.name, "b.mesh");
});

test("S6: a file that can't be read leaves both meshes as they are, and says so", async () => {
  const all = await opened();
  await assert.rejects(all.comparing.openFiles([fileOf("bad.mesh", { lacks: "broken" })]));
  await settled();
  assert.deepEqual(present(all), BOTH);
  assert.equal(all.seconds[0].closed, false);
  assert.deepEqual(
    all.said().map(([severity]) => severity),
    ["error"],
    "once",
  );
  await all.comparing.openFiles([fileOf("c.mesh", { cells: "hexes" })]);
  assert.deepEqual(all.said(), [], "the next good one takes it back");
});

test("S6: a first second mesh that can't be read leaves nothing behind", async () => {
  const all = await opened({}, null);
  await assert.rejects(all.comparing.openFiles([fileOf("bad.mesh", { lacks: "broken" })]));
  await settled();
  assert.equal(all.facts.get("second"), null);
  assert.equal(all.comparing.second, null);
  assert.equal(all.seconds[0].closed, true);
  assert.deepEqual(present(all).compared[0], null);
  assert.deepEqual(
    all.said().map(([severity]) => severity),
    ["error"],
  );
});

test("S6: of two that are opened at once the later counts, and nothing is left if that can't be read", async () => {
  const all = await opened({}, null);
  const good = all.comparing.openFiles([fileOf("b.mesh")]);
  const bad = all.comparing.openFiles([fileOf("bad.mesh", { lacks: "broken" })]);
  await Promise.allSettled([good, bad]);
  await settled();
  assert.equal(all.seconds.length, 1);
  assert.equal(all.facts.get("second"), null, "no view stands empty");
});

test("S6: closed while it is being opened, a second mesh says nothing", async () => {
  const all = await opened({}, null);
  const opening = all.comparing.openFiles([fileOf("b.mesh")]);
  await new Promise((resolve) => setTimeout(resolve));
  all.comparing.close();
  await opening;
  await settled();
  assert.equal(all.facts.get("second"), null);
  assert.deepEqual(all.said(), []);
});

test("S6: without a first mesh, or where there is no room for a second, it is refused in words", async () => {
  const empty = page();
  await assert.rejects(empty.comparing.openFiles([fileOf("b.mesh")]), /Open a mesh first/);
  await assert.rejects(empty.comparing.openFiles([fileOf("b.stl", { surface: true })]), /Open a mesh first/);
  const alone = page({ alone: true });
  assert.equal(alone.comparing.possible, false);
  await alone.app.openFiles([fileOf("a.mesh")]);
  await assert.rejects(alone.comparing.openFiles([fileOf("b.mesh")]), /can't be shown here/);
  assert.equal(alone.said().length, 1);
  await alone.comparing.openFiles([fileOf("b.stl", { surface: true })]);
  assert.equal(alone.facts.get("comparison")?.name, "b.stl", "a surface needs no room");
});

test("S6: closed, the second mesh goes with its core, and the first is compared with nothing", async () => {
  const all = await opened();
  all.comparing.close();
  await settled();
  assert.deepEqual(present(all), {
    cores: ["a.mesh", "b.mesh"],
    compared: [null, "a.mesh"],
    told: undefined,
    named: "",
  });
  const [{ core, scene, closed }] = all.seconds;
  assert.deepEqual([core.closed, scene.disposed, closed], [true, true, true]);
  assert.equal(all.facts.get("second"), null);
  assert.equal(all.facts.get("together"), false);
  const methods = all.core.asked.map(([method]) => method);
  assert.ok(methods.lastIndexOf("update") > methods.indexOf("stop_comparing"), "it is drawn without it");
  assert.deepEqual(all.said(), []);
});

/** @param {string} quantity */
const band = (quantity) => ({ quantity, keep: /** @type {const} */ ("inside"), minimum: 0, maximum: null });

test("S6: closed, colours, filters and arrows that came from the comparison go, and no others", async () => {
  const all = await opened({ cells: "hexes", attributes: ["cell:heat"] });
  all.store.set({
    colour: {
      by: "attribute",
      attribute: "change:volume",
      metric: "volume",
      map: "diverging",
      range: [-1, 1],
    },
    arrows: { attribute: "compare:displacement", length: 0.2 },
    filters: { quality: { items: ["change:volume", "volume", "cell:heat", "compare:distance"].map(band) } },
    compare: { picking: { hidden: [3] }, layout: "curtain", camera: "own" },
  });
  await settled();
  all.comparing.close();
  await settled();
  const { colour, arrows, filters, compare } = all.store.status;
  assert.deepEqual(colour, { ...DEFAULTS.colour, by: "quality", metric: "volume" });
  assert.deepEqual(arrows, { ...DEFAULTS.arrows, length: 0.2 });
  assert.deepEqual(filters.quality.items, ["volume", "cell:heat"].map(band));
  assert.deepEqual(compare, { ...DEFAULTS.compare, layout: "curtain", camera: "own" });
  assert.deepEqual(all.said(), [], "no core was asked for what it does not know");
});

test("S6: closed, colours that have nothing to do with it stay", async () => {
  const all = await opened({ cells: "hexes", attributes: ["cell:heat"] });
  all.store.set({
    colour: { by: "attribute", attribute: "cell:heat", range: [0, 9] },
    arrows: { length: 0.1 },
  });
  const before = all.store.status;
  all.comparing.close();
  assert.equal(all.store.status.colour, before.colour);
  assert.equal(all.store.status.arrows, before.arrows);
});

test("S6: cells that were picked of one second mesh are none of the next one's, unless it has as many", async () => {
  const all = await opened({ cells: "hexes" }, { cells: "others", count: 5 });
  const picking = { isolated: true, hidden: [], shown: [4] };
  all.store.set({ compare: { picking } });
  await all.comparing.openFiles([fileOf("c.mesh", { cells: "more", count: 5 })]);
  assert.deepEqual(all.store.status.compare.picking, picking);
  await all.comparing.openFiles([fileOf("d.mesh", { cells: "less", count: 3 })]);
  assert.deepEqual(all.store.status.compare.picking, DEFAULTS.compare.picking);
  all.store.undo();
  assert.equal(all.store.canUndo, false, "that they went is no step that could be undone");
});

test("S6: cells that a link says are picked of the second mesh are picked when it comes", async () => {
  const all = await opened({}, null);
  const picking = { isolated: false, hidden: [1], shown: [] };
  all.store.set({ compare: { picking } });
  await all.comparing.openFiles([fileOf("b.mesh", { cells: "others", count: 5 })]);
  await settled();
  assert.deepEqual(all.seconds[0].side.store.status.filters.picking.hidden, [1]);
});

test("S6: the tool at hand is that of both, though the second mesh came after it was taken", async () => {
  const all = await opened({}, null);
  all.facts.set({ tool: "dig" });
  await all.comparing.openFiles([fileOf("b.mesh")]);
  const second = all.seconds[0].side.facts;
  assert.equal(second.get("tool"), "dig");
  all.facts.set({ tool: "undig" });
  assert.equal(second.get("tool"), "undig");
  all.comparing.close();
  all.facts.set({ tool: "turn" });
  assert.equal(second.get("tool"), "undig", "one that was closed follows no more");
});

test("S6: one of the catalogue, or an address, is named beside the first; a file, and what failed, is not", async () => {
  const all = await opened({}, null);
  const named = /** @type {(string | null)[]} */ ([]);
  all.app.steps.beside = (address) => void named.push(address);
  const hashes = /** @type {unknown[]} */ ([]);
  all.app.fetching.from = (address, known) => {
    hashes.push(known?.sha256);
    const file = fileOf(address, address.endsWith(".stl") ? { surface: true } : {});
    return { name: address, address, bytes: () => file.arrayBuffer() };
  };
  const mesh = { url: "meshes/duck.mesh", slug: "fine", sha256: "5a" };
  const catalogue = {
    entry: (/** @type {string} */ source) => (source === "ducks" ? { source: {}, mesh } : null),
  };
  all.app.catalogue = /** @type {any} */ (Promise.resolve(catalogue));
  await all.comparing.openEntry("ducks", "fine");
  assert.equal(all.seconds[0].core.mesh?.name, "https://meshes.example/meshes/duck.mesh");
  assert.deepEqual(hashes, ["5a"], "whose content is known");
  await all.comparing.openUrl("https://other.example/b.mesh");
  await all.comparing.openUrl("https://other.example/wing.stl");
  await all.comparing.openFiles([fileOf("c.mesh")]);
  const addresses = ["https://other.example/b.mesh", "https://other.example/wing.stl"];
  assert.deepEqual(named, ["ducks/fine", ...addresses, null]);
  await assert.rejects(all.comparing.openEntry("geese", "fine"), /has no mesh geese\/fine/);
  await assert.rejects(all.comparing.openFiles([fileOf("bad.mesh", { lacks: "broken" })]));
  assert.equal(named.length, 4);
});

test("S6: a mesh of the catalogue that can't be read is no surface, and that is said once", async () => {
  const all = await opened({}, null);
  const file = fileOf("duck.mesh", { lacks: "broken", surface: true });
  all.app.fetching.from = (address) => ({ name: "duck.mesh", address, bytes: () => file.arrayBuffer() });
  const entry = { source: {}, mesh: { url: "duck.mesh", slug: "fine" } };
  all.app.catalogue = /** @type {any} */ (Promise.resolve({ entry: () => entry }));
  await assert.rejects(all.comparing.openEntry("ducks", "fine"), /duck.mesh: can't be read/);
  await settled();
  assert.deepEqual(all.said(), [["error", "duck.mesh: can't be read"]]);
  assert.equal(all.core.questions("compare_with_surface").length, 0);
});
