import assert from "node:assert/strict";
import { test } from "node:test";
import { differByALetter, find, plain, readIndex } from "../../../static/catalogue/index.js";
import { decimal } from "../../../static/catalogue/results.js";
import { compare } from "../../../static/catalogue/sorting.js";

const INDEX = readIndex({
  version: 1,
  facets: [
    { id: "origin", options: ["own", "published"] },
    { id: "cells", options: ["s", "m", "unknown"] },
    { id: "validity", options: ["valid", "positive", "invalid"] },
  ],
  models: ["Bunny rabbit", "Ball", "Ball joint"],
  sources: [
    ["grids", "Grids & more", "Ana Núñez", 2020, "Journal", "10.5555/a", "Núñez 2020"],
    ["balls", "Balls", "J. Doe", 2023, "Journal", "", "Doe 2023"],
  ],
  meshes: [
    [0, "cube", "Cube", 512, 1, 1, 1, 0, 1, "000", "", 24, 1],
    [0, "bar", "Bar", 4000, 0.5, 0.9, 1, 12, 0, "010", "A beam to be bent.", 40, 118],
    [1, "bunny", "Bunny", null, null, null, null, null, 0, "121", "", null, null, 0],
    [1, "ball", "Ball 10", 99, -0.2, 0.5, 1, 3, 2, "102", "", null, null, 1],
  ],
});
const NOTHING = { words: "", source: "", model: "", sort: "", chosen: {} };

/** @param {object} query */
const names = (query) => find(INDEX, { ...NOTHING, ...query }).rows.map((row) => row.name);

test("C2 all is found when nothing is asked, in its order", () => {
  assert.deepEqual(names({}), ["Cube", "Bar", "Bunny", "Ball 10"]);
});

test("T6 sheets and blocks are known of what was traced", () => {
  assert.deepEqual(
    INDEX.rows.map(({ sheets, blocks }) => [sheets, blocks]),
    [
      [24, 1],
      [40, 118],
      [null, null],
      [null, null],
    ],
  );
});

test("C2 meshes of a body are found by its title or a part of it", () => {
  assert.deepEqual(names({ model: "bunny" }), ["Bunny"]);
  assert.deepEqual(names({ model: "BALL" }), ["Ball 10"]);
  assert.deepEqual(names({ model: "ball j" }), [], "the body is known, but none of these is a mesh of it");
  assert.deepEqual(names({ words: "rabbit" }), ["Bunny"]);
  assert.deepEqual(names({ model: "cube" }), []);
});

test("C2 a facet may have more than ten options", () => {
  const index = readIndex({
    facets: [{ id: "method", options: [..."abcdefghijkl"] }],
    sources: [["s", "", "", 2016, "", "", ""]],
    meshes: ["0", "9", "a", "b"].map((code) => [0, code, code, 1, 1, 1, 1, 0, 0, code]),
  });
  const { rows, counts } = find(index, { ...NOTHING, chosen: { method: ["k", "j"] } });
  assert.deepEqual(
    rows.map(({ slug }) => slug),
    ["9", "a"],
  );
  assert.deepEqual(counts[0], [1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1]);
});

test("C2 a row knows its validity and its picture", () => {
  assert.deepEqual(
    INDEX.rows.map(({ validity, picture }) => [validity, picture]),
    [
      [0, "png"],
      [0, ""],
      [1, ""],
      [2, "webp"],
    ],
  );
});

test("C2 words are found in names, titles, authors, years and DOIs, without accents", () => {
  assert.deepEqual(names({ words: "NUNEZ bar" }), ["Bar"]);
  assert.deepEqual(names({ words: "10.5555" }), ["Cube", "Bar"]);
  assert.deepEqual(names({ words: "2023 bun" }), ["Bunny"]);
  assert.deepEqual(names({ words: "beam" }), ["Bar"]);
  assert.deepEqual(names({ words: "nowhere" }), []);
  assert.equal(plain("Núñez ℓ"), "nunez l");
});

test("C2 spellings of one name find each other", () => {
  const index = readIndex({
    facets: [],
    sources: [["s", "Sweeping", "A. B.", 2016, "", "", ""]],
    meshes: ["rockerarm", "Rocker arm", "rocker_arm-2", "arm"].map((name) => [0, name, name]),
  });
  for (const words of ["rockerarm", "rocker arm", "rocker_arm", "Rocker-Arm"])
    assert.equal(find(index, { ...NOTHING, words }).rows.length, 3, words);
});

test("C2 a wrong letter is forgiven where nothing has the word", () => {
  for (const words of ["bnuny", "buny", "bunnny", "bonny", "bunn"])
    assert.deepEqual(names({ words }), ["Bunny"], words);
  assert.deepEqual(names({ words: "baby" }), []);
  assert.deepEqual(names({ words: "cub" }), ["Cube"]);
  assert.equal(find(INDEX, { ...NOTHING, words: "bnuny" }).forgiven, true);
  assert.equal(find(INDEX, { ...NOTHING, words: "bunny" }).forgiven, false);
  assert.ok(differByALetter("armadillo", "armadilo") && differByALetter("armadillo", "armadi"));
  assert.ok(!differByALetter("arm", "armadillo") && !differByALetter("gear", "bear2"));
});

test("C2 options of one facet add up, facets narrow each other", () => {
  assert.deepEqual(names({ chosen: { cells: ["s", "unknown"] } }), ["Cube", "Bunny", "Ball 10"]);
  assert.deepEqual(names({ chosen: { cells: ["s"], origin: ["published"] } }), ["Ball 10"]);
  assert.deepEqual(names({ source: "balls" }), ["Bunny", "Ball 10"]);
});

test("C2 counts say what a further choice would find", () => {
  const { counts } = find(INDEX, { ...NOTHING, chosen: { origin: ["own"] } });
  assert.deepEqual(counts, [
    [2, 2],
    [1, 1, 0],
    [2, 0, 0],
  ]);
});

test("C2 what is not known comes last, whichever way it is sorted", () => {
  assert.deepEqual(names({ sort: "cells" }), ["Ball 10", "Cube", "Bar", "Bunny"]);
  assert.deepEqual(names({ sort: "-cells" }), ["Bar", "Cube", "Ball 10", "Bunny"]);
  assert.deepEqual(names({ sort: "sj" }), ["Ball 10", "Bar", "Cube", "Bunny"]);
  assert.deepEqual(names({ sort: "year" }), ["Bunny", "Ball 10", "Cube", "Bar"]);
  assert.deepEqual(names({ sort: "blocks" }), ["Cube", "Bar", "Bunny", "Ball 10"]);
  assert.deepEqual(names({ sort: "-blocks" }), ["Bar", "Cube", "Bunny", "Ball 10"]);
  assert.deepEqual(names({ sort: "name" }), ["Ball 10", "Bar", "Bunny", "Cube"]);
});

test("C2 names with numbers sort as people count", () => {
  assert.ok(compare("mesh 9", "mesh 10", false) < 0);
  assert.ok(compare(null, 3, true) > 0);
});

test("C2 numbers read as on the pages made at build", () => {
  assert.equal(decimal(0.12345), "0.123");
  assert.equal(decimal(-1), "−1.000");
  assert.equal(decimal(0.0001234), "1.234e−4");
  assert.equal(decimal(0), "0");
  assert.equal(decimal(null), "–");
});
