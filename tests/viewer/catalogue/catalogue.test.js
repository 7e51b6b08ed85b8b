import assert from "node:assert/strict";
import { test } from "node:test";
import { Catalogue } from "../../../static/viewer/catalogue/catalogue.js";

const INDEX = {
  sources: [
    {
      slug: "grids",
      title: "Grids",
      authors: [],
      meshes: [
        {
          slug: "cube",
          name: "Cube",
          cells: 8,
          url: "meshes/grids/cube.mesh",
          remote: false,
          sha256: "aa",
          preview: "meshes/grids/cube.hxb",
        },
        {
          slug: "bar",
          name: "Bar",
          cells: 27,
          url: "https://example.org/bar.vtk",
          remote: true,
          picture: "pictures/grids/bar.webp",
        },
      ],
    },
  ],
};

const catalogue = new Catalogue(INDEX, "https://site.example/hexalab/");

test("C4: addresses are relative to the site's root, wherever it lies", () => {
  assert.equal(
    catalogue.entry("grids", "cube")?.mesh.url,
    "https://site.example/hexalab/meshes/grids/cube.mesh",
  );
  assert.equal(
    catalogue.entry("grids", "cube")?.mesh.preview,
    "https://site.example/hexalab/meshes/grids/cube.hxb",
  );
  assert.equal(catalogue.entry("grids", "bar")?.mesh.url, "https://example.org/bar.vtk");
  assert.equal(
    catalogue.entry("grids", "bar")?.mesh.picture,
    "https://site.example/hexalab/pictures/grids/bar.webp",
  );
  assert.equal(catalogue.entry("grids", "none"), null);
});

test("S3: the mesh of a status is found by its SHA-256, else by file name and cells", () => {
  assert.equal(catalogue.identified({ sha256: "aa" })?.mesh.slug, "cube");
  assert.equal(catalogue.identified({ name: "bar.vtk", cells: 27 })?.mesh.slug, "bar");
  assert.equal(catalogue.identified({ name: "bar.vtk", cells: 28 }), null);
  assert.equal(catalogue.identified({ name: "", cells: 8 }), null);
});

test("the mesh before and after, in the same source", () => {
  const cube = catalogue.entry("grids", "cube");
  assert.ok(cube);
  assert.equal(catalogue.beside(cube, 1)?.mesh.slug, "bar");
  assert.equal(catalogue.beside(cube, -1), null);
});
