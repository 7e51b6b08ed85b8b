import assert from "node:assert/strict";
import { createServer } from "node:http";
import { after, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { download } from "../../../static/offline/download.js";

/** @type {import("node:http").Server} */
let server;
let root = "";

before(async () => {
  server = createServer((request, response) => {
    if (request.url === "/whole") response.end("abc");
    else if (request.url === "/missing") response.writeHead(404, "Not Found").end();
    else if (request.url === "/long")
      response.writeHead(200, { "content-length": "5000" }).end("x".repeat(5000));
    else if (request.url === "/endless") response.write("x".repeat(6000));
    else if (request.url === "/packed")
      response.writeHead(200, { "content-encoding": "gzip" }).end(gzipSync("x".repeat(4000)));
    else if (request.url === "/stuck") response.writeHead(200, { "content-length": "100" }).write("abc");
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(undefined)));
  root = `http://127.0.0.1:${/** @type {import("node:net").AddressInfo} */ (server.address()).port}`;
  Object.assign(globalThis, { location: new URL(root) });
});
after(() => {
  server.closeAllConnections();
  server.close();
});

test("S1 a file comes with what has come so far", async () => {
  /** @type {(number | undefined)[]} */
  const sizes = [];
  const bytes = await download(`${root}/whole`, (_fraction, _text, size) => sizes.push(size));
  assert.equal(new TextDecoder().decode(bytes), "abc");
  assert.equal(sizes.at(-1), 3);
});

/** What is told last of a file of 4000 bytes that comes packed. @param {number} [size] that is known */
async function toldOfPacked(size) {
  /** @type {[number | null, string | undefined][]} */
  const told = [];
  await download(`${root}/packed`, (fraction, text) => told.push([fraction, text]), { size });
  return told.at(-1);
}

test("C8 of a file that comes packed, how much is to come is told where its size is known", async () => {
  assert.deepEqual(await toldOfPacked(), [null, "fetching, 4.0 kB"]);
  assert.deepEqual(await toldOfPacked(4000), [1, "fetching, 4.0 kB of 4.0 kB"]);
  assert.deepEqual(await toldOfPacked(900), [null, "fetching, 4.0 kB"], "a size that proves wrong");
});

test("O5 what a server refuses is said", async () => {
  await assert.rejects(
    download(`${root}/missing`, () => {}),
    /answered 404 Not Found/,
  );
});

test("O3 a file that is too large is left, announced or not", async () => {
  const most = 4000;
  await assert.rejects(
    download(`${root}/long`, () => {}, { most }),
    /sends 5.0 kB, and 4.0 kB are the most/,
  );
  await assert.rejects(
    download(`${root}/endless`, () => {}, { most }),
    /and 4.0 kB are the most/,
  );
});

test("O3 a server that sends nothing more is left", async () => {
  await assert.rejects(
    download(`${root}/stuck`, () => {}, { patience: 300 }),
    /has sent nothing for 0 seconds/,
  );
});

test("O1 who cancels gets no words", async () => {
  const controller = new AbortController();
  setTimeout(() => controller.abort(), 50);
  await assert.rejects(
    download(`${root}/stuck`, () => {}, { signal: controller.signal }),
    { name: "AbortError" },
  );
});
