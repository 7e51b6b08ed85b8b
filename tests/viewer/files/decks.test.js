import assert from "node:assert/strict";
import { test } from "node:test";
import { includedBy, includedIn, wholes } from "../../../static/viewer/files/decks.js";

/** @param {Record<string, string>} files */
async function found(files) {
  const given = Object.entries(files).map(([path, text]) => ({ path, text }));
  const isMesh = (/** @type {string} */ path) => /\.(inp|msh|vtk)(\.gz)?$/i.test(path);
  const all = await wholes(given, isMesh, async ({ text }) => includedBy(text));
  return Object.fromEntries(all.map(({ mesh, parts }) => [mesh.path, parts.map(({ path }) => path)]));
}

test("names of included files, as decks spell them", () => {
  const text = [
    "*HEADING",
    "*Include, INPUT=mesh.inp",
    '  *include ,input = "parts\\Nodes.INC" ',
    "** *INCLUDE, INPUT=no.inp",
    "*NODE, NSET=all, INPUT = nodes.txt",
    "*ELEMENT, TYPE=C3D8,",
    " ELSET=body, INPUT='cells of it.dat'",
    "*BOUNDARY, OP=NEW",
    "1, 2, 3 INPUT=no.inp",
    "",
  ].join("\n");
  const names = ["mesh.inp", "parts\\Nodes.INC", "nodes.txt", "cells of it.dat"];
  assert.deepEqual(includedBy(text), names);
  assert.deepEqual(includedBy(text.replaceAll("\n", "\r\n")), names);
});

/** @param {Uint8Array<ArrayBuffer>[]} pieces */
function inPieces(...pieces) {
  const start = (/** @type {ReadableStreamDefaultController} */ control) => {
    for (const piece of pieces) control.enqueue(piece);
    control.close();
  };
  return /** @type {Blob} */ (/** @type {unknown} */ ({ stream: () => new ReadableStream({ start }) }));
}

test("R5 a deck is looked through in pieces, which may end within a name or a letter", async () => {
  const text = new TextEncoder().encode("1, 2\n*INCLUDE, INPUT=größe.inc\r\n3, 4\r\n*include,input=b.inc");
  for (let at = 0; at <= text.length; at++) {
    const names = await includedIn(inPieces(text.slice(0, at), text.slice(at)), "a.inp");
    assert.deepEqual(names, ["größe.inc", "b.inc"]);
  }
  const bytes = [...text].map((byte) => Uint8Array.of(byte));
  assert.deepEqual(await includedIn(inPieces(...bytes), "a.inp"), ["größe.inc", "b.inc"]);
});

test("R5 a large deck is looked through whole, gzipped or not; Latin-1 is read where it is no UTF-8", async () => {
  const filler = "1, 0.25, 0.5, 0.75\n".repeat(40_000);
  const names = Array.from({ length: 30 }, (_, index) => `part-${index}.inc`);
  const deck = new Blob(names.map((name) => `${filler}*INCLUDE, INPUT=${name}\n`));
  assert.deepEqual(await includedIn(deck, "a.inp"), names);
  const gzipped = await new Response(deck.stream().pipeThrough(new CompressionStream("gzip"))).blob();
  assert.deepEqual(await includedIn(gzipped, "a.inp.gz"), names);
  const latin = Uint8Array.from("*INCLUDE, INPUT=größe.inc\n", (letter) => letter.charCodeAt(0));
  assert.deepEqual(await includedIn(new Blob([latin]), "a.inp"), ["größe.inc"]);
  assert.deepEqual(await includedIn(new Blob(["*INCLUDE, INPUT=a"]), "no-gzip.inp.gz"), []);
  const endless = await includedIn(new Blob(["x".repeat(2 ** 22), "\n*INCLUDE, INPUT=b.inc"]), "a.inp");
  assert.deepEqual(endless, ["b.inc"]);
});

test("R5 a file that a deck includes is no mesh of its own, whatever it is called", async () => {
  assert.deepEqual(await found({ "mesh.inp": "*NODE", "job.inp": "*INCLUDE, INPUT=mesh.inp" }), {
    "job.inp": ["mesh.inp"],
  });
  const names = "*INCLUDE, INPUT=all.msh\n*INCLUDE, INPUT=fix.nam\n*INCLUDE, INPUT=loads.txt";
  assert.deepEqual(await found({ "all.msh": "", "job.inp": names, "fix.nam": "", "loads.txt": "", "x.log": "" }), {
    "job.inp": ["all.msh", "fix.nam", "loads.txt"],
  }); // prettier-ignore
  assert.deepEqual(await found({ "a.vtk": "", "b.inp": "", "c.msh": "" }), { "a.vtk": [], "b.inp": [], "c.msh": [] }); // prettier-ignore
});

test("R5 parts of parts are parts, too; decks that include each other are all shown", async () => {
  const chain = { "job.inp": "*INCLUDE, INPUT=a.inc", "a.inc": "*INCLUDE, INPUT=b.inc", "b.inc": "" };
  assert.deepEqual(await found(chain), { "job.inp": ["a.inc", "b.inc"] });
  const loop = { "a.inp": "*INCLUDE, INPUT=b.inp", "b.inp": "*INCLUDE, INPUT=a.inp" };
  assert.deepEqual(await found(loop), { "a.inp": ["b.inp"], "b.inp": ["a.inp"] });
  const own = { "a.inp": "*INCLUDE, INPUT=a.inp", "b.inp": "" };
  assert.deepEqual(await found(own), { "a.inp": [], "b.inp": [] });
});

test("R5 of files with one name the one in the deck's own folder is meant; without folders any", async () => {
  const two = { "x/job.inp": "*INCLUDE, INPUT=./Mesh.inp", "x/mesh.inp": "", "y/mesh.inp": "" };
  assert.deepEqual(await found(two), { "x/job.inp": ["x/mesh.inp"], "y/mesh.inp": [] });
  const flat = { "job.inp": "*INCLUDE, INPUT=..\\parts\\mesh.inp", "mesh.inp": "" };
  assert.deepEqual(await found(flat), { "job.inp": ["mesh.inp"] });
});
