import assert from "node:assert/strict";
import { test } from "node:test";
import { changedPaths, merge } from "../../../static/viewer/state/paths.js";
import { fromSecond, secondStatus } from "../../../static/viewer/state/second_status.js";
import { DEFAULTS } from "../defaults.js";

/** @typedef {import("../../../static/viewer/state/second_status.js").Second} Second */
/** @typedef {import("../../../static/viewer/state/status.js").PartialStatus} PartialStatus */

/** Settings that count the first mesh's cells, parts, sheets and groups. */
const STATUS = merge(DEFAULTS, {
  mesh: { name: "a.mesh", sha256: "aa", cells: 100 },
  camera: { fit: false, target: [1, 0, 0], distance: 4 },
  filters: {
    picking: { enabled: true, isolated: false, hidden: [3, 70], shown: [8] },
    parts: { enabled: true, isolated: true, hidden: [], shown: [1] },
    groups: { enabled: true, isolated: true, hidden: ["elset:A"], shown: ["elset:B", "elset:C"] },
    structure: { keep: "outside", blocks: [1], sheets: [2, 3], chords: [4] },
    peel: { depth: 2 },
  },
  marks: {
    hidden: ["edges:reference:1", "faces:surface:S"],
    nodes: ["nset:N", "nset:M"],
    interfaces: "elset",
  },
  structure: { kind: "sheets", chosen: [5, 6], explode: 0.2 },
  compare: {
    other: { name: "b.mesh", sha256: "bb", cells: 50 },
    picking: { isolated: true, hidden: [2, 49, 50], shown: [7, 60] },
  },
});

/** @type {Second} */
const SAME = { same: true, cells: 100, has: () => true, groups: () => true, frames: null, reach: null };
const OTHER = { ...SAME, same: false, cells: 50 };

/** Frames whose centres are (0, 0, 0) and (2, 0, 0); the second is twice as large. */
const FRAMES = { first: { centre: [0, 0, 0], diagonal: 1 }, second: { centre: [2, 0, 0], diagonal: 2 } };

/** Settings in which the second differs. @param {Second} second @param {typeof STATUS} [status] */
const changes = (second, status = STATUS) => changedPaths(status, secondStatus(status, second));

test("S6: a second mesh of the same cells is drawn as the first, but that it is another", () => {
  assert.deepEqual(changes(SAME).sort(), ["mesh.cells", "mesh.name", "mesh.sha256"]);
  assert.deepEqual(secondStatus(STATUS, SAME).mesh, STATUS.compare.other);
});

test("S6: of other cells, those are picked that were picked of them, as far as there are so many", () => {
  const { picking } = secondStatus(STATUS, OTHER).filters;
  assert.deepEqual(picking, { enabled: true, isolated: true, hidden: [2, 49], shown: [7] });
  const off = merge(STATUS, { filters: { picking: { enabled: false } } });
  assert.equal(secondStatus(off, OTHER).filters.picking.enabled, false, "both are switched by one switch");
});

test("S6: of other cells, numbers of parts, blocks, sheets and chords are no others' numbers", () => {
  const { filters, structure } = secondStatus(STATUS, OTHER);
  assert.deepEqual(filters.parts, { enabled: true, isolated: false, hidden: [], shown: [] });
  assert.deepEqual(filters.structure, {
    ...STATUS.filters.structure,
    blocks: [],
    sheets: [],
    chords: [],
  });
  assert.deepEqual(structure, { ...STATUS.structure, chosen: [] });
});

test("S6: what counts nothing is that of both, whatever the cells", () => {
  const counting = [
    "mesh",
    "filters.picking",
    "filters.parts",
    "filters.structure",
    "structure.chosen",
    "marks",
  ];
  for (const path of changes(OTHER))
    assert.ok(
      counting.some((one) => path.startsWith(`${one}.`) || path === one),
      path,
    );
});

test("S6: groups and marks that a mesh has not are left out, those that it has stay in their order", () => {
  const known = ["elset:C", "nset:M", "edges:reference:1"];
  const { filters, marks } = secondStatus(STATUS, { ...OTHER, groups: (id) => known.includes(id) });
  assert.deepEqual(filters.groups, { enabled: true, isolated: true, hidden: [], shown: ["elset:C"] });
  assert.deepEqual(marks.hidden, ["edges:reference:1"]);
  assert.deepEqual(marks.nodes, ["nset:M"]);
  assert.equal(marks.interfaces, "", "two groups of other cells meet elsewhere");
  const same = secondStatus(STATUS, { ...SAME, groups: (id) => known.includes(id) });
  assert.deepEqual(same.filters.groups.shown, ["elset:C"], "of the same cells as well");
  assert.equal(same.marks, STATUS.marks);
});

test("S6: a mesh that has none of the groups that are shown alone is not hidden whole", () => {
  for (const second of [SAME, OTHER]) {
    const { groups } = secondStatus(STATUS, { ...second, groups: () => false }).filters;
    assert.deepEqual(groups, { enabled: true, isolated: false, hidden: [], shown: [] });
  }
});

test("S6: attributes that it has not are left out", () => {
  const heated = merge(STATUS, {
    colour: { by: "attribute", attribute: "cell:heat" },
    arrows: { attribute: "point:flow" },
  });
  const drawn = secondStatus(heated, { ...SAME, has: (id) => id === "point:flow" });
  assert.equal(drawn.colour.by, "sides");
  assert.equal(drawn.arrows.attribute, "point:flow");
});

test("S6: the camera is that of the first in each one's frame, or stands at the same place for both", () => {
  assert.equal(secondStatus(STATUS, OTHER).camera, STATUS.camera);
  const { camera } = secondStatus(STATUS, { ...OTHER, frames: FRAMES });
  // The target (1, 0, 0) of the first is (-1, 0, 0) from the second's centre, half of a diagonal.
  assert.deepEqual(camera, { ...STATUS.camera, target: [-0.5, 0, 0], distance: 2 });
});

test("S6: colours are made for the range of both where that is common to them", () => {
  assert.equal(secondStatus(STATUS, SAME).colour, STATUS.colour);
  assert.deepEqual(secondStatus(STATUS, { ...SAME, reach: [0, 7] }).colour.reach, [0, 7]);
});

/** What is set at the second mesh, as it reads it afterwards. @param {PartialStatus} partial @param {Second} second */
function setAt(partial, second) {
  const status = merge(STATUS, fromSecond(partial, second));
  return { status, second: secondStatus(status, second) };
}

test("S6: what is set at a second mesh is what it reads, in either frame and of any cells", () => {
  /** @type {PartialStatus[]} */
  const partials = [
    { filters: { picking: { enabled: true, isolated: false, hidden: [4], shown: [] } } },
    { filters: { peel: { depth: 5 }, picking: { hidden: [1] } } },
    { mesh: { name: "c.mesh", sha256: "cc", cells: 7 } },
    { mesh: { sha256: "dd" } },
    { camera: { target: [0.25, 0, -1], distance: 3, fit: false } },
    { camera: { distance: 8 } },
    { compare: { divider: 0.3 }, mesh: { name: "e.mesh" } },
    { colour: { by: "quality" }, silhouette: 0 },
  ];
  for (const second of [SAME, OTHER, { ...SAME, frames: FRAMES }, { ...OTHER, frames: FRAMES }])
    for (const partial of partials) {
      const read = setAt(partial, second).second;
      const others = changedPaths(merge(secondStatus(STATUS, second), partial), read);
      assert.deepEqual(
        others.filter((path) => !path.startsWith("compare.")), // where the one status has it
        [],
        JSON.stringify(partial),
      );
    }
});

test("S6: the second mesh's name goes to the comparison, and the first keeps its own", () => {
  const { status } = setAt({ mesh: { name: "c.mesh", sha256: "cc", cells: 7 } }, OTHER);
  assert.deepEqual(status.mesh, STATUS.mesh);
  assert.deepEqual(status.compare.other, { name: "c.mesh", sha256: "cc", cells: 7 });
  assert.equal(status.compare.picking, STATUS.compare.picking);
});

test("S6: cells picked at a second mesh of the same cells are picked of both; else the first's stay", () => {
  const picking = { enabled: true, isolated: true, hidden: [], shown: [9] };
  const same = setAt({ filters: { picking } }, SAME).status;
  assert.deepEqual(same.filters.picking, picking);
  assert.equal(same.compare.picking, STATUS.compare.picking);
  const { status } = setAt({ filters: { picking } }, OTHER);
  assert.equal(status.filters, STATUS.filters);
  assert.deepEqual(status.compare.picking, { isolated: true, hidden: [], shown: [9] });
});

test("S6: a cell that is hidden at a second mesh switches the filter on, so that it is seen to be hidden", () => {
  const off = merge(STATUS, { filters: { picking: { enabled: false } } });
  const picking = { enabled: true, isolated: false, hidden: [4], shown: [] };
  const status = merge(off, fromSecond({ filters: { picking } }, OTHER));
  assert.deepEqual(secondStatus(status, OTHER).filters.picking, picking);
  assert.deepEqual(status.filters.picking.hidden, STATUS.filters.picking.hidden);
});

test("S6: the camera at a second mesh is mapped back, and one in its own frame is the first's as it is", () => {
  const camera = { target: /** @type {const} */ ([-0.5, 0, 0]), distance: 2 };
  assert.deepEqual(fromSecond({ camera }, { same: true, frames: FRAMES }).camera, {
    target: [1, 0, 0],
    distance: 4,
  });
  assert.deepEqual(fromSecond({ camera }, OTHER), { camera });
  assert.deepEqual(fromSecond({}, OTHER), {});
});
