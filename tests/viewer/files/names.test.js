import assert from "node:assert/strict";
import { test } from "node:test";
import { safeStem, stemOf } from "../../../static/viewer/files/names.js";

test("names keep all of the mesh's name but its ending", () => {
  assert.equal(stemOf("a.b.c.mesh.gz"), "a.b.c");
  assert.equal(stemOf("2019.part.v2.vtk"), "2019.part.v2");
  assert.equal(safeStem("fig10-DEMO09-1.hh.sat-ours.vtk"), "fig10-DEMO09-1.hh.sat-ours");
  assert.equal(safeStem("folder/a:b?.inp"), "folder-a-b-");
  assert.equal(safeStem("mesh"), "mesh");
  assert.equal(safeStem(""), "hexalab");
});
