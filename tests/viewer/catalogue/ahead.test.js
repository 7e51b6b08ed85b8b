import assert from "node:assert/strict";
import { afterEach, beforeEach, test } from "node:test";
import { Ahead } from "../../../static/viewer/catalogue/ahead.js";

const ROOT = "https://site.org/hexalab/";
const ROW = {
  slug: "cube",
  name: "Cube",
  url: "meshes/shapes/cube.mesh",
  preview: "meshes/shapes/cube.preview",
};
const FAR = {
  slug: "far",
  name: "Far",
  url: "https://far.example/far.mesh",
  picture: "pictures/shapes/far.webp",
};
const INDEX = { sources: [{ slug: "shapes", title: "Shapes", authors: [], meshes: [ROW, FAR] }] };
const PREVIEW = `${ROOT}meshes/shapes/cube.preview`;

/** @type {string[]} */
let asked = [];
const fetching = globalThis.fetch;

const settled = () => new Promise((resolve) => setTimeout(resolve, 5));

beforeEach(() => {
  asked = [];
  Object.assign(globalThis, {
    location: new URL(`${ROOT}viewer/`),
    fetch: async (/** @type {string | URL} */ address) => {
      asked.push(String(address));
      return String(address).endsWith(".json") ? Response.json(INDEX) : new Response("abc");
    },
  });
});
afterEach(() => Object.assign(globalThis, { fetch: fetching }));

test("O2 the preview is asked for as soon as the catalogue is there, and only once", async () => {
  const ahead = new Ahead(ROOT, "shapes/cube");
  await settled();
  assert.deepEqual(asked, [`${ROOT}catalogue.json`, PREVIEW]);
  assert.equal((await ahead.bytes(PREVIEW)).byteLength, 3);
  assert.equal(asked.length, 2);
  await ahead.bytes(PREVIEW);
  assert.equal(asked.length, 3); // what was used is asked for anew
});

test("C8 of a mesh that lies elsewhere the portrait is asked for", async () => {
  const ahead = new Ahead(ROOT, "shapes/far");
  await settled();
  const picture = `${ROOT}pictures/shapes/far.webp`;
  assert.deepEqual(asked, [`${ROOT}catalogue.json`, picture]);
  assert.equal((await ahead.bytes(picture)).byteLength, 3);
  assert.equal(asked.length, 2);
});

test("O2 another preview is fetched when it is wanted", async () => {
  const ahead = new Ahead(ROOT, "shapes/other");
  await settled();
  assert.deepEqual(asked, [`${ROOT}catalogue.json`]);
  await ahead.bytes(`${ROOT}other.preview`);
  assert.equal(asked.at(-1), `${ROOT}other.preview`);
});

test("O2 a catalogue that does not come is told to whoever needs it", async () => {
  Object.assign(globalThis, { fetch: () => Promise.reject(new Error("no network")) });
  await assert.rejects(new Ahead(ROOT, "shapes/cube").catalogue, /no network/);
});
