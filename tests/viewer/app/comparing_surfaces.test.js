import assert from "node:assert/strict";
import { test } from "node:test";
import { DEFAULTS } from "../defaults.js";
import { fileOf } from "./fake_core.js";
import { page, settled } from "./two_sides.js";

const SURFACE = { surface: true };

/** A page with a mesh that is compared with some files in turn. @param {...File} files */
async function opened(...files) {
  const all = page();
  await all.app.openFiles([fileOf("a.mesh", { cells: "hexes" })]);
  for (const file of files) await all.comparing.openFiles([file]);
  await settled();
  return all;
}

/** A promise that is kept when it is told. */
function gate() {
  let open = () => {};
  const waits = /** @type {Promise<void>} */ (new Promise((resolve) => (open = resolve)));
  return { waits, open };
}

test("S7: a surface is read by the first core, drawn over the mesh and named", async () => {
  const { core, seconds, facts, store, said } = await opened(fileOf("wing.stl", SURFACE));
  assert.equal(core.compared, "wing.stl");
  assert.equal(facts.get("comparison")?.name, "wing.stl");
  assert.deepEqual(store.status.compare.other, { name: "wing.stl", sha256: "", cells: 0 });
  assert.equal(store.status.compare.reference.shown, true);
  assert.equal(seconds.length, 0, "no second mesh was begun for it");
  assert.equal(store.canUndo, false);
  const methods = core.asked.map(([method]) => method);
  assert.ok(methods.lastIndexOf("update") > methods.indexOf("compare_with_surface"), "it is drawn");
  assert.deepEqual(said(), []);
});

test("S7: what was noted while it was read is told", async () => {
  const { said } = await opened(fileOf("wing.stl", { surface: true, notes: ["2 triangles have no area."] }));
  assert.deepEqual(said(), [["note", "2 triangles have no area."]]);
});

test("S7: an ending of surfaces alone says that it is one; of others the content does", async () => {
  for (const name of ["wing.stl", "WING.STL", "wing.stl.gz"]) {
    const { seconds, facts } = await opened(fileOf(name, SURFACE));
    assert.equal(seconds.length, 0, name);
    assert.equal(facts.get("comparison")?.name, name);
  }
  for (const name of ["b.mesh", "b.vtk", "b.stl.mesh", "no ending"]) {
    const { seconds, core } = await opened(fileOf(name, { cells: "hexes" }));
    assert.equal(seconds[0]?.core.mesh?.name, name);
    assert.equal(core.questions("compare_with_surface").length, 0);
  }
});

for (const lacks of /** @type {const} */ (["no cells", "broken"]))
  test(`S7: a file that is no mesh (${lacks}) is taken as a surface, where it is one`, async () => {
    const { core, facts, seconds, said } = await opened(fileOf("wing.vtk", { lacks, surface: true }));
    assert.equal(core.compared, "wing.vtk");
    assert.equal(facts.get("comparison")?.name, "wing.vtk");
    assert.equal(facts.get("second"), null);
    assert.equal(seconds[0].closed, true);
    assert.deepEqual(said(), [], "that it is no mesh is no error");
  });

test("S7: what failed for another reason is not tried as a surface", async () => {
  const all = await opened(fileOf("b.mesh", { cells: "hexes" }));
  all.seconds[0].core.fails.open = new Error("out of memory");
  await assert.rejects(all.comparing.openFiles([fileOf("c.vtk", SURFACE)]), /out of memory/);
  assert.equal(all.core.questions("compare_with_surface").length, 0);
  assert.equal(all.facts.get("comparison")?.name, "b.mesh");
});

test("S7: files that came with it go with it to whoever reads it", async () => {
  const { core, comparing } = await opened();
  await comparing.openFiles([fileOf("wing.stl", SURFACE), fileOf("part.inc", {})]);
  const [[name, , parts]] = core.questions("compare_with_surface");
  assert.equal(name, "wing.stl");
  assert.deepEqual(Object.keys(parts), ["part.inc"]);
});

test("S7: a surface closes the second mesh when it was read, and not before", async () => {
  const { comparing, core, seconds, facts } = await opened(fileOf("b.mesh", { cells: "hexes" }));
  const { waits, open } = gate();
  core.waits.compare_with_surface = waits;
  const opening = comparing.openFiles([fileOf("wing.stl", SURFACE)]);
  await settled();
  assert.equal(facts.get("second")?.get("summary")?.name, "b.mesh");
  assert.equal(facts.get("comparison")?.name, "b.mesh");
  assert.equal(seconds[0].closed, false);
  open();
  await opening;
  assert.equal(facts.get("second"), null);
  assert.equal(seconds[0].closed, true);
  assert.equal(facts.get("comparison")?.name, "wing.stl");
});

test("S7: a surface that can't be read leaves the second mesh, and a surface from before, as they are", async () => {
  const beside = await opened(fileOf("b.mesh", { cells: "hexes" }));
  await assert.rejects(beside.comparing.openFiles([fileOf("bad.stl")]), /no surface/);
  assert.equal(beside.facts.get("comparison")?.name, "b.mesh");
  assert.equal(beside.seconds[0].closed, false);
  assert.deepEqual(beside.said(), [["error", "bad.stl: no surface"]]);
  const over = await opened(fileOf("wing.stl", SURFACE));
  await assert.rejects(over.comparing.openFiles([fileOf("bad.stl")]));
  await assert.rejects(over.comparing.openFiles([fileOf("bad.mesh", { lacks: "broken" })]));
  await settled();
  assert.equal(over.core.compared, "wing.stl");
  assert.equal(over.facts.get("comparison")?.name, "wing.stl");
  assert.equal(over.facts.get("second"), null);
  assert.equal(over.store.status.compare.other.name, "wing.stl");
});

test("S7: the next surface takes back what was said of one that can't be read, and what was measured of others", async () => {
  const { comparing, facts, said } = await opened(fileOf("wing.stl", SURFACE));
  facts.set({ apart: /** @type {any} */ ({ hausdorff: 1 }) });
  await assert.rejects(comparing.openFiles([fileOf("bad.stl")]));
  assert.equal(facts.get("apart")?.hausdorff, 1, "it is of the surface that is there yet");
  await comparing.openFiles([fileOf("other.stl", SURFACE)]);
  assert.deepEqual(said(), []);
  assert.equal(facts.get("apart"), null);
});

test("S6: a second mesh takes the place of a surface, and stays", async () => {
  const { core, seconds, facts, store } = await opened(
    fileOf("wing.stl", SURFACE),
    fileOf("b.mesh", { cells: "hexes" }),
  );
  assert.deepEqual([core.compared, seconds[0].core.compared], ["b.mesh", "a.mesh"]);
  assert.equal(facts.get("comparison")?.name, "b.mesh");
  assert.equal(facts.get("second")?.get("summary")?.name, "b.mesh");
  assert.equal(store.status.compare.other.name, "b.mesh");
  assert.equal(store.status.compare.reference.shown, false, "only the surface was drawn because it is one");
});

test("S7: another first mesh is measured against the same surface", async () => {
  const { app, core, facts } = await opened(fileOf("wing.stl", SURFACE));
  await app.openFiles([fileOf("c.mesh")]);
  await settled();
  assert.deepEqual([core.mesh?.name, core.compared], ["c.mesh", "wing.stl"]);
  assert.equal(facts.get("comparison")?.name, "wing.stl");
});

test("S7: a core that was started anew is given the surface, or the other mesh, again", async () => {
  for (const file of [fileOf("wing.stl", SURFACE), fileOf("b.mesh", { cells: "hexes" })]) {
    const { app, core, facts } = await opened(file);
    app.followCore();
    Object.assign(core, { mesh: null, compared: null });
    core.dispatchEvent(new Event("died"));
    core.dispatchEvent(new Event("restarted"));
    await settled();
    assert.deepEqual([core.mesh?.name, core.compared], ["a.mesh", file.name]);
    assert.equal(facts.get("comparison")?.name, file.name);
  }
});

test("S7: ended while the core has failed, it is asked for nothing", async () => {
  const { comparing, core, facts } = await opened(fileOf("wing.stl", SURFACE));
  facts.set({ core: "failed" });
  comparing.close();
  await settled();
  assert.equal(core.questions("stop_comparing").length, 0);
  assert.equal(facts.get("comparison"), null);
});

test("S7: ended, the surface is not taken again, nor one that was still being read", async () => {
  const { app, comparing, core, facts, said } = await opened(fileOf("wing.stl", SURFACE));
  const { waits, open } = gate();
  core.waits.compare_with_surface = waits;
  const opening = comparing.openFiles([fileOf("other.stl", SURFACE)]);
  await new Promise((resolve) => setTimeout(resolve));
  comparing.close();
  open();
  await opening.catch(() => {});
  await settled();
  assert.equal(facts.get("comparison"), null);
  assert.equal(core.compared, null);
  await app.openFiles([fileOf("c.mesh")]);
  await settled();
  assert.equal(core.compared, null);
  assert.deepEqual(said(), []);
});

test("S7: what was known of the distance to one surface is not told of the next", async () => {
  const all = await opened(fileOf("wing.stl", SURFACE));
  const known = () => {
    const { histogram, worst, statistics } = /** @type {any} */ ({
      histogram: all.facts.get("histogram"),
      worst: all.facts.get("worst"),
      statistics: all.facts.get("statistics")["compare:distance"],
    });
    return [histogram.of, worst.of, statistics.of];
  };
  all.store.set({ colour: { by: "attribute", attribute: "compare:distance" } });
  await settled();
  assert.deepEqual(known(), Array(3).fill("compare:distance of a.mesh and wing.stl"));
  await all.comparing.openFiles([fileOf("other.stl", SURFACE)]);
  await settled();
  assert.deepEqual(known(), Array(3).fill("compare:distance of a.mesh and other.stl"));
});

test("S7: what the core has at hand is measured against or stands beside, as it is a surface or a mesh", async () => {
  const files = {
    0: { name: "a.mesh", body: { cells: "hexes" } },
    1: { name: "b.mesh", body: { cells: "hexes" } },
    2: { name: "wing.stl", body: SURFACE },
  };
  const offers = [
    { id: "0", name: "a.mesh" },
    { id: "1", name: "b.mesh" },
    { id: "2", name: "wing.stl", surface: true },
  ];
  const { app, comparing, core, seconds, facts, said } = page({ offers: files });
  facts.set({ offers });
  await app.opening.open({ name: "a.mesh", offered: "0" });
  await comparing.openOffered("1");
  await settled();
  assert.deepEqual(core.questions("compare_with_offered"), [["1", true]]);
  assert.deepEqual(seconds[0].core.questions("compare_with_offered"), [["0", false]]);
  assert.equal(facts.get("comparison")?.name, "b.mesh");
  await comparing.openOffered("2");
  assert.equal(facts.get("comparison")?.name, "wing.stl");
  assert.equal(facts.get("second"), null);
  assert.deepEqual(said(), []);
  await assert.rejects(comparing.openOffered("7"), /nothing is offered by the name of 7/);
});

test("S7: colours that a link has of the distance wait for the surface", async () => {
  const all = await opened();
  all.store.set({ colour: { by: "attribute", attribute: "compare:distance" } });
  assert.equal(all.app.look.status.colour.by, "sides");
  await all.comparing.openFiles([fileOf("wing.stl", SURFACE)]);
  await settled();
  assert.equal(all.app.look.status.colour.by, "attribute");
  assert.equal(all.facts.get("histogram")?.quantity, "compare:distance");
  assert.deepEqual(all.said(), []);
});

test("S7: ended, no name and no picked cell is left of what it was compared with, nor what was noted or measured", async () => {
  const { comparing, store, facts, said, app } = await opened(
    fileOf("wing.stl", { surface: true, notes: ["Odd."] }),
  );
  facts.set({ apart: /** @type {any} */ ({ hausdorff: 1 }) });
  const named = /** @type {(string | null)[]} */ ([]);
  app.steps.beside = (address) => void named.push(address);
  comparing.close();
  assert.deepEqual(said(), []);
  assert.equal(facts.get("apart"), null);
  assert.deepEqual(named, [null]);
  assert.equal(store.canUndo, false);
  assert.deepEqual(store.status.compare, DEFAULTS.compare);
});
