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

test("B1: the table tells the unit of each mesh where one was named, and has no column for it where none was", async () => {
  const done = async () => {};
  const host = (/** @type {string} */ unit) => ({
    store: { status: { unit } },
    tables: { metrics: [], statistics: [] },
    facts: { get: () => null },
    opening: { open: async () => ({ vertices: 8, cells: 1, boundary_faces: 6 }) },
    comparing: {
      stands: false,
      second: null,
      sides: [
        {
          opening: { identified: Promise.resolve() },
          drawing: { drawn: done },
          measures: { measured: done, filled: Promise.resolve() },
        },
      ],
    },
    messages: { settle: () => {} },
    saving: { picture: async () => new Blob([]), histogram: async () => null },
  });
  const portrayed = async (/** @type {string} */ unit) => {
    const batch = new Batch(/** @type {any} */ (host(unit)));
    const how = { layers: async () => [], size: {}, figures: false };
    return rowOf((await batch.portray("a.mesh", "a", { name: "a.mesh" }, how)).measured);
  };
  assert.equal((await portrayed("mm")).unit, "mm");
  assert.deepEqual(Object.keys(await portrayed("none")), [
    "name",
    "problem",
    "picture",
    "vertices",
    "cells",
    "boundary_faces",
  ]);
});
