import assert from "node:assert/strict";
import { test } from "node:test";
import { meshAddress, nameIn } from "../../../static/viewer/app/address.js";

const PAGE = "https://site.org/hexalab/viewer/";

test("S1 addresses that a page can read", () => {
  assert.equal(meshAddress("https://x.org/50%25.mesh", PAGE), "https://x.org/50%25.mesh");
  assert.equal(meshAddress("../meshes/a.vtk", PAGE), "https://site.org/hexalab/meshes/a.vtk");
  assert.equal(meshAddress("a.mesh", "http://localhost:8000/viewer/"), "http://localhost:8000/viewer/a.mesh");
  assert.equal(meshAddress("blob:https://site.org/1-2", PAGE), "blob:https://site.org/1-2");
});

test("S1 others are refused in words that are true", () => {
  for (const [address, words] of /** @type {[string, RegExp][]} */ ([
    ["http://x.org/a.mesh", /only https addresses, and those of this site/],
    ["file:///tmp/a.mesh", /drop the file here/],
    ["ftp://x.org/a.mesh", /begin with ftp: can't be read, expected https/],
    ["javascript:alert(1)", /begin with javascript: can't be read/],
    ["https://[x", /is no address of a mesh/],
    ["https://x y:z/", /is no address of a mesh/],
  ]))
    assert.throws(() => meshAddress(address, PAGE), words);
  assert.throws(() => meshAddress("http://x.org/a", "http://localhost:8000/"), /those of this site/);
});

test("S1 a % that is no escape stands for itself", () => {
  assert.equal(nameIn("https://x.org/50%25.mesh"), "50%.mesh");
  assert.equal(nameIn("https://x.org/a/50%.mesh"), "50%.mesh");
  assert.equal(nameIn("https://x.org/%zz%20.vtk"), "%zz%20.vtk");
  assert.equal(nameIn("https://x.org/"), "mesh");
});
