import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateSync } from "node:zlib";
import { readStatus, writeStatus } from "../../../static/viewer/files/png_text.js";

/** A chunk whose checksum is not looked at by readers of text. @param {string} type @param {Buffer} data */
function chunk(type, data) {
  const size = Buffer.alloc(4);
  size.writeUInt32BE(data.length);
  return Buffer.concat([size, Buffer.from(type), data, Buffer.alloc(4)]);
}

const SIGNATURE = Buffer.from([137, 80, 78, 71, 13, 10, 26, 10]);
/** @param {...Buffer} between */
const picture = (...between) =>
  Buffer.concat([SIGNATURE, chunk("IHDR", Buffer.alloc(13)), ...between, chunk("IEND", Buffer.alloc(0))]);
/** @param {Buffer} bytes @returns {ArrayBuffer} */
const buffer = (bytes) =>
  /** @type {ArrayBuffer} */ (bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));

test("S3: a picture carries the settings, and gives them back letter by letter", async () => {
  const text = JSON.stringify({ mesh: { name: "Größe – 測試.mesh" }, version: 1 });
  const written = await writeStatus(new Blob([picture()]), text);
  assert.equal(written.type, "image/png");
  assert.equal(await readStatus(await written.arrayBuffer()), text);
});

test("S3: the chunk is iTXt, before IEND, with the checksum that the PNG specification asks for", async () => {
  const bytes = Buffer.from(await (await writeStatus(new Blob([picture()]), "{}")).arrayBuffer());
  const at = bytes.indexOf("iTXthexalab");
  assert.ok(at > 0 && at < bytes.indexOf("IEND"));
  const length = bytes.readUInt32BE(at - 4);
  const { crc32 } = await import("node:zlib");
  if (crc32) assert.equal(bytes.readUInt32BE(at + 4 + length), crc32(bytes.subarray(at, at + 4 + length)));
});

test("S3: tEXt, zTXt and compressed iTXt are read; other keywords are not", async () => {
  const text = '{"camera":{}}';
  const plain = chunk("tEXt", Buffer.from(`hexalab\0${text}`));
  const packed = chunk("zTXt", Buffer.concat([Buffer.from("hexalab\0\0"), deflateSync(text)]));
  const international = chunk(
    "iTXt",
    Buffer.concat([Buffer.from("hexalab\0\x01\0en\0settings\0"), deflateSync(text)]),
  );
  for (const one of [plain, packed, international])
    assert.equal(await readStatus(buffer(picture(one))), text);
  assert.equal(await readStatus(buffer(picture(chunk("tEXt", Buffer.from(`comment\0${text}`))))), null);
});

test("S3: what is no picture, or is cut short, is named", async () => {
  await assert.rejects(readStatus(buffer(Buffer.from("MeshVersionFormatted 1"))), /no PNG/);
  await assert.rejects(
    readStatus(buffer(picture(chunk("tEXt", Buffer.alloc(64))).subarray(0, 60))),
    /cut short/,
  );
});

test("S3: settings take the place of those that the picture carried", async () => {
  const first = await writeStatus(new Blob([picture()]), '{"a": 1}');
  const second = Buffer.from(await (await writeStatus(first, '{"b": 2}')).arrayBuffer());
  assert.equal(await readStatus(buffer(second)), '{"b": 2}');
  assert.equal(second.toString("latin1").split("iTXthexalab").length, 2);
});

test("S3: settings that unpack to more than 16 MB are refused while they are unpacked", async () => {
  const bomb = Buffer.concat([Buffer.from("hexalab\0\0"), deflateSync(Buffer.alloc(2 ** 25))]);
  await assert.rejects(readStatus(buffer(picture(chunk("zTXt", bomb)))), /more than 16 MB when unpacked/);
});
