import assert from "node:assert/strict";
import { test } from "node:test";
import { meshesOf } from "../../../static/viewer/batch/archive.js";
import { Batch, rowOf, toCsv } from "../../../static/viewer/batch/batch.js";
import { stemOf } from "../../../static/viewer/files/names.js";

const FORMATS = [{ extensions: [".mesh"] }, { extensions: [".vtk"] }];

test("B1: meshes are told by their extension, gzipped or not; hidden files are left alone", () => {
  const names = [
    "a.mesh",
    "deep/B.VTK",
    "c.mesh.gz",
    "a.json",
    ".hidden.mesh",
    "__MACOSX/a.mesh",
    "meshes.txt",
  ];
  const entries = names.map((name) => ({ name, read: async () => new Uint8Array() }));
  assert.deepEqual(
    meshesOf(entries, FORMATS).map(({ name }) => name),
    ["a.mesh", "deep/B.VTK", "c.mesh.gz"],
  );
});

test("B1: what stands beside a mesh has its name without the extension", () => {
  assert.equal(stemOf("deep/part.v2.mesh"), "deep/part.v2");
  assert.equal(stemOf("a.vtk.gz"), "a");
});

test("B1: the table has every column that any row has, and quotes what needs it", () => {
  /** @type {import("../../../static/viewer/batch/batch.js").Row[]} */
  const rows = [
    { name: 'a "b", c', cells: 3 },
    { name: "d", problem: "line 1:\nfound" },
  ];
  assert.equal(toCsv(rows), 'name,cells,problem\r\n"a ""b"", c",3,\r\nd,,"line 1:\nfound"\r\n');
});

const done = async () => {};

/** What a batch needs of an application that shows a mesh of one cell. @param {object} [more] */
function hostOf(more = {}) {
  const side = {
    opening: { identified: Promise.resolve() },
    drawing: { drawn: done },
    measures: { measured: done, filled: Promise.resolve() },
  };
  return {
    store: { status: { unit: "none", compare: { other: { name: "b.mesh" } } } },
    tables: { metrics: [], statistics: [] },
    facts: { get: () => null },
    opening: { open: async () => ({ vertices: 8, cells: 1, boundary_faces: 6 }) },
    comparing: { stands: false, second: null, sides: [side], matched: Promise.resolve() },
    messages: { settle: () => {} },
    saving: { picture: async () => new Blob([]), histogram: async () => null },
    ...more,
  };
}

/** @param {object} host @param {object} [more] how */
async function portrayed(host, more = {}) {
  const batch = new Batch(/** @type {any} */ (host));
  const how = { layers: async () => [], size: {}, figures: false, ...more };
  return (await batch.portray("a.mesh", "a", { name: "a.mesh" }, how)).measured;
}

test("B1: the table tells the unit of each mesh where one was named, and has no column for it where none was", async () => {
  assert.equal(rowOf(await portrayed(hostOf({ store: { status: { unit: "mm" } } }))).unit, "mm");
  assert.deepEqual(Object.keys(rowOf(await portrayed(hostOf()))), [
    "name",
    "problem",
    "picture",
    "vertices",
    "cells",
    "boundary_faces",
  ]);
});

/** Distances from one surface to another. @param {number} max */
const way = (max) => ({
  vertices: 8,
  max,
  mean: max / 2,
  rms: max / 1.5,
  max_percent: 10 * max,
  mean_percent: 5 * max,
  rms_percent: 6 * max,
  worst: [0, 0, 0],
});
const apart = { a_to_b: way(1), b_to_a: way(2), hausdorff: 2, hausdorff_percent: 20 };
const ours = { min: 0.5, mean: 0.75, max: 1, median: 0.7 };
const theirs = { min: 0.25, mean: 0.75, max: null, median: 0.7 };
const changes = { worse: 1, better: 2, same: 3, largest_loss: 0.5, cells: [7] };

/** The same of one that compares. @param {{ same?: boolean, second?: boolean, measured?: object | null }} [how] */
function comparingHost({ same = true, second = true, measured = apart } = {}) {
  /** @type {string[]} */
  const calls = [];
  const noted = (/** @type {string} */ name) => async (/** @type {unknown} */ value) =>
    void calls.push(`${name} ${JSON.stringify(value)}`);
  const side = (/** @type {object} */ numbers) => ({
    client: { call: async () => numbers },
    opening: { identified: Promise.resolve() },
    drawing: { drawn: done },
    measures: { measured: done, filled: Promise.resolve() },
  });
  const [first, other] = [side(ours), side(theirs)];
  const comparing = {
    stands: false,
    second: null,
    sides: [first],
    matched: Promise.resolve(),
    distances: { measure: async () => measured },
    changes: async () => (same ? changes : null),
    openOffered: async (/** @type {string} */ id) => {
      calls.push(`compare ${id}`);
      Object.assign(comparing, { stands: true }, second ? { second: other, sides: [first, other] } : {});
    },
    close: () => void calls.push("close"),
  };
  const told = { name: "b.mesh", same_cells: same, volume_ratio: 1.25 };
  const host = hostOf({
    client: first.client,
    tables: { metrics: [{ id: "skew" }], statistics: ["min", "max"] },
    facts: { get: (/** @type {string} */ name) => (name === "comparison" ? told : null) },
    opening: {
      open: async (/** @type {{ layers: unknown }} */ { layers }) => {
        await noted("open")(layers);
        return { vertices: 8, cells: 1, boundary_faces: 6 };
      },
    },
    documents: { replaceBy: noted("settings") },
    comparing,
    saving: {
      picture: async () => (calls.push("picture"), new Blob([])),
      figure: async () => (calls.push("figure"), new Blob([])),
      histogram: async () => null,
    },
  });
  return {
    host,
    calls,
    how: { layers: async () => [{ silhouette: 1 }], beside: { id: "1", name: "b/b.mesh" } },
  };
}

test("B2: what a mesh is compared with has columns of its own, after all others", async () => {
  const { host, how } = comparingHost();
  const measured = await portrayed(host, how);
  const row = rowOf(measured);
  const columns = Object.keys(row);
  assert.deepEqual(columns.slice(columns.indexOf("boundary_faces") + 1), [
    "skew_min",
    "skew_max",
    "with",
    "same_cells",
    "hausdorff",
    "hausdorff_percent",
    ...["a_to_b", "b_to_a"].flatMap((name) =>
      ["max", "mean", "rms"].flatMap((what) => [
        `distance_${name}_${what}`,
        `distance_${name}_${what}_percent`,
      ]),
    ),
    "volume_ratio",
    "skew_difference_min",
    "skew_difference_mean",
    "skew_difference_max",
    "skew_worse",
    "skew_better",
  ]);
  const told = [row.with, row.same_cells, row.hausdorff, row.distance_b_to_a_max_percent, row.volume_ratio];
  assert.deepEqual(told, ["b/b.mesh", "true", 2, 20, 1.25]);
  assert.deepEqual([row.skew_worse, row.skew_better], [1, 2]);
  assert.deepEqual(
    [row.skew_difference_min, row.skew_difference_mean, row.skew_difference_max],
    [-0.25, "", ""],
    "this table has no mean, and the other mesh no maximum",
  );
  assert.deepEqual(measured.comparison?.changes, { skew: changes });
  assert.equal(measured.comparison?.distance, apart);
});

test("B2: of other cells nothing is counted, of a surface no metric is told", async () => {
  const { host, how } = comparingHost({ same: false });
  const others = rowOf(await portrayed(host, how));
  assert.equal(others.same_cells, "false");
  assert.ok("skew_difference_min" in others && !("skew_worse" in others));
  const film = comparingHost({ same: false, second: false });
  const surface = rowOf(await portrayed(film.host, film.how));
  assert.equal(surface.hausdorff, 2);
  assert.deepEqual(
    Object.keys(surface).filter((name) => name.startsWith("skew_")),
    ["skew_min", "skew_max"],
  );
});

test("B2: settings come when both meshes know of each other; the picture shows both; then the comparison ends", async () => {
  const two = comparingHost();
  await portrayed(two.host, two.how);
  assert.deepEqual(two.calls, ["open []", "compare 1", 'settings [{"silhouette":1}]', "figure", "close"]);
  const film = comparingHost({ second: false });
  await portrayed(film.host, film.how);
  const shown = '{"compare":{"reference":{"shown":true}}}';
  assert.deepEqual(film.calls, [
    "open []",
    "compare 1",
    `settings [${shown},{"silhouette":1}]`,
    "picture",
    "close",
  ]);
});

test("B2: what can't be compared is told in the table, and ends, too", async () => {
  const { host, how, calls } = comparingHost({ measured: null });
  const row = rowOf(await portrayed(host, how));
  assert.deepEqual(row, { name: "a.mesh", problem: "it could not be compared with b/b.mesh" });
  assert.equal(calls.at(-1), "close");
});
