import assert from "node:assert/strict";
import { test } from "node:test";
import { parcelOf } from "../../../static/offline/parcel.js";
import { fileSize } from "../../../static/offline/sizes.js";

const ROOT = "https://site.org/hexalab/";
const SOURCE = {
  slug: "some-2020",
  meshes: [
    {
      slug: "own",
      name: "Own",
      url: "meshes/some-2020/own.mesh",
      bytes: 10,
      preview: "meshes/some-2020/own.preview",
    },
    { slug: "far", name: "Far", url: "https://far.org/far.mesh", sha256: "ab" },
  ],
};

test("O1 a source's parcel has its page, and of each mesh page, file and preview", () => {
  assert.deepEqual(parcelOf(SOURCE, "", ROOT), {
    meshes: [
      { name: "Own", address: `${ROOT}meshes/some-2020/own.mesh`, bytes: 10, sha256: "" },
      { name: "Far", address: "https://far.org/far.mesh", bytes: null, sha256: "ab" },
    ],
    pages: ["", "own/", "far/"].map((page) => `${ROOT}sources/some-2020/${page}index.html`),
    previews: [`${ROOT}meshes/some-2020/own.preview`],
  });
});

test("O1 a single mesh's parcel has no other", () => {
  const { meshes, pages, previews } = parcelOf(SOURCE, "far", ROOT);
  assert.deepEqual(
    meshes.map(({ name }) => name),
    ["Far"],
  );
  assert.deepEqual(pages, [`${ROOT}sources/some-2020/far/index.html`]);
  assert.deepEqual(previews, []);
});

test("V9 sizes as people read them", () => {
  for (const [size, words] of /** @type {const} */ ([
    [0, "0 B"],
    [999, "999 B"],
    [1500, "1.5 kB"],
    [123456, "123 kB"],
    [4.2e6, "4.2 MB"],
    [2e9, "2.0 GB"],
    [null, "size not known"],
  ]))
    assert.equal(fileSize(size), words);
});
