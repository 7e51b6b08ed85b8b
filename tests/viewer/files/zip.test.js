import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";
import { readZip, writeZip } from "../../../static/viewer/files/zip.js";

/** Runs Python's zipfile: the tool whose archives must be read, and that must read ours. @param {string} program @param {Buffer} [input] */
function python(program, input) {
  const { stdout, stderr, status } = spawnSync(
    "python3",
    ["-c", `import sys, io, json, zipfile\n${program}`],
    { input },
  );
  assert.equal(status, 0, String(stderr));
  return stdout;
}

/** @param {Buffer} bytes @returns {ArrayBuffer} */
const buffer = (bytes) =>
  /** @type {ArrayBuffer} */ (bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));

const PACK = `
file = io.BytesIO()
with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
    archive.writestr("folder/", "")
    archive.writestr("folder/größe.mesh", "abc" * 1000)
    archive.writestr("plain.txt", "plain", zipfile.ZIP_STORED)
sys.stdout.buffer.write(file.getvalue())`;

test("B1: what Python packs is read, deflated and stored, folders left out", async () => {
  const entries = readZip(buffer(python(PACK)));
  assert.deepEqual(entries.map(({ name }) => name), ["folder/größe.mesh", "plain.txt"]); // prettier-ignore
  const texts = await Promise.all(entries.map(async ({ read }) => new TextDecoder().decode(await read())));
  assert.deepEqual(texts, ["abc".repeat(1000), "plain"]);
});

test("B1: what is written here, Python reads, checksums and all", async () => {
  const files = [
    { name: "a.csv", bytes: new TextEncoder().encode("x,y\r\n1,2\r\n") },
    { name: "größe.png", bytes: Uint8Array.from({ length: 70000 }, (_, at) => at % 251) },
  ];
  const zip = Buffer.from(await writeZip(files).arrayBuffer());
  const report = python(
    `
archive = zipfile.ZipFile(io.BytesIO(sys.stdin.buffer.read()))
assert archive.testzip() is None
json.dump([[row.filename, row.file_size, archive.read(row)[-3:].hex()] for row in archive.infolist()], sys.stdout)`,
    zip,
  );
  const expected = files.map(({ name, bytes }) => [
    name,
    bytes.length,
    Buffer.from(bytes.slice(-3)).toString("hex"),
  ]);
  assert.deepEqual(JSON.parse(String(report)), expected);
});

test("B1: what is no archive, or is cut short, is named", async () => {
  assert.throws(() => readZip(new ArrayBuffer(100)), /no ZIP archive/);
  assert.throws(() => readZip(buffer(python(PACK).subarray(0, -10))), /no ZIP archive, or it is cut short/);
});

const BOMB = `
file = io.BytesIO()
with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
    archive.writestr("bomb.mesh", bytes(80 * 2**20))
    archive.writestr("text.mesh", "1 2 3 4 " * 100000)
sys.stdout.buffer.write(file.getvalue())`;

test("O3: a file of an archive that becomes far too large is left, the others are read", async () => {
  const entries = readZip(buffer(python(BOMB)));
  await assert.rejects(entries[0].read(), /bomb.mesh: more than 64 MB when unpacked/);
  assert.equal((await entries[1].read()).length, 800000);
});
