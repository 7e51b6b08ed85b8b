import assert from "node:assert/strict";
import { test } from "node:test";
import { includedBy, mainOf } from "../../../static/viewer/app/decks.js";

const part = (/** @type {string} */ path, text = "") => ({ path, text: async () => text });
const names = async (/** @type {ReturnType<typeof part>[]} */ ...files) =>
  (await mainOf(files)).map(({ path }) => path);

test("names of included files, as decks spell them", () => {
  const text =
    '*HEADING\n*Include, INPUT=mesh.inp\n*include ,input = "parts\\Nodes.INC" \n** *INCLUDE, INPUT=no.inp\n';
  assert.deepEqual(includedBy(text), ["mesh.inp", "nodes.inc"]);
});

test("R5 a deck that another includes is no mesh of its own", async () => {
  const job = part("job.inp", "*INCLUDE, INPUT=mesh.inp");
  assert.deepEqual(await names(part("mesh.inp", "*NODE"), job), ["job.inp"]);
  assert.deepEqual(await names(part("a/mesh.inp"), part("a/job.inp", "*INCLUDE, INPUT=MESH.INP")), [
    "a/job.inp",
  ]);
  assert.deepEqual(await names(part("a.vtk"), part("b.inp")), ["a.vtk", "b.inp"]);
  const loop = part("job.inp", "*INCLUDE, INPUT=job.inp");
  assert.deepEqual(await names(loop, part("x.inp", "*INCLUDE, INPUT=x.inp")), ["job.inp", "x.inp"]);
});
