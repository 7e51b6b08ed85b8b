import { crc32 } from "./crc32.js";
import { inflated } from "./inflate.js";

/**
 * ZIP archives as far as a batch needs them (PKWARE's APPNOTE 6.3): reading stored and deflated entries through the
 * central directory, writing stored ones. Sizes in the archive are not believed: what is inflated is counted.
 *
 * @typedef {{ name: string, read: () => Promise<Uint8Array<ArrayBuffer>> }} Entry
 */

const END = 0x06054b50;
const CENTRAL = 0x02014b50;
const LOCAL = 0x04034b50;
const UTF8 = 0x0800;
const ENCRYPTED = 1;

/** Numbers that stand for "see the 64-bit fields". */
const ELSEWHERE = [0xffff, 0xffffffff];

/** Compression methods that are met and not read. @type {Record<number, string>} */
const METHODS = {
  9: "9 (Deflate64)",
  12: "12 (bzip2)",
  14: "14 (LZMA)",
  93: "93 (Zstandard)",
  95: "95 (XZ)",
  99: "99 (AES encryption)",
};

/** Widths of the fields that local and central headers share: flags to the extra field's length. */
const COMMON = "222244422";

export const MOST_ENTRIES = 10_000;
export const MOST_BYTES = 2 ** 30;

/** Nor may a file become more than so many times as large, above what is always fine: text of meshes shrinks 3 to 30 times. */
const RATIO = 200;
const ALWAYS_FINE = 64 * 2 ** 20;

/** @param {ArrayBuffer} buffer @returns {Entry[]} the files in it, folders left out */
export function readZip(buffer) {
  const view = new DataView(buffer);
  const end = findEnd(view);
  const count = view.getUint16(end + 10, true);
  const entries = [];
  let at = view.getUint32(end + 16, true);
  if (ELSEWHERE.includes(count) || ELSEWHERE.includes(at))
    throw new Error(
      "the archive has the 64-bit form (ZIP64), for more than 4 GB: unpack it and open the files",
    );
  if (count > MOST_ENTRIES)
    throw new Error(`found ${count} files in the archive, expected at most ${MOST_ENTRIES}`);
  for (let index = 0; index < count; index++) {
    if (at + 46 > buffer.byteLength || view.getUint32(at, true) !== CENTRAL)
      throw new Error("the archive's list of files is broken");
    const [nameLength, extra, comment] = [28, 30, 32].map((offset) => view.getUint16(at + offset, true));
    const name = new TextDecoder().decode(new Uint8Array(buffer, at + 46, nameLength));
    const row = {
      encrypted: Boolean(view.getUint16(at + 8, true) & ENCRYPTED),
      method: view.getUint16(at + 10, true),
      size: view.getUint32(at + 20, true),
      local: view.getUint32(at + 42, true),
    };
    if (!name.endsWith("/")) entries.push({ name, read: () => unpack(buffer, name, row) });
    at += 46 + nameLength + extra + comment;
  }
  return entries;
}

/** The end of the central directory, searched from behind. @param {DataView} view */
function findEnd(view) {
  const first = Math.max(0, view.byteLength - 22 - 65535);
  for (let at = view.byteLength - 22; at >= first; at--) if (view.getUint32(at, true) === END) return at;
  throw new Error("this is no ZIP archive, or it is cut short");
}

/** @param {ArrayBuffer} buffer @param {string} name @param {{ encrypted: boolean, method: number, size: number, local: number }} row */
async function unpack(buffer, name, { encrypted, method, size, local }) {
  if (encrypted)
    throw new Error(`${name} is encrypted: unpack the archive with its password and open the files`);
  const view = new DataView(buffer);
  if (local + 30 > buffer.byteLength || view.getUint32(local, true) !== LOCAL)
    throw new Error(`${name}: the archive is broken here`);
  const start = local + 30 + view.getUint16(local + 26, true) + view.getUint16(local + 28, true);
  if (start + size > buffer.byteLength) throw new Error(`${name}: the archive is cut short here`);
  const bytes = new Uint8Array(buffer, start, size);
  if (method === 0) return bytes.slice();
  if (method !== 8)
    throw new Error(
      `${name}: found compression method ${METHODS[method] ?? method}, expected 0 (stored) or 8 (deflated): pack it with the usual settings`,
    );
  const most = Math.min(MOST_BYTES, Math.max(ALWAYS_FINE, RATIO * size));
  return inflated(bytes, "deflate-raw", { most, name });
}

/** @param {readonly { name: string, bytes: Uint8Array<ArrayBuffer> }[]} files @returns {Blob} */
export function writeZip(files) {
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const parts = [];
  const directory = [];
  let offset = 0;
  for (const { name, bytes } of files) {
    const encoded = new TextEncoder().encode(name);
    const common = [UTF8, 0, 0, 0x21, crc32(bytes), bytes.length, bytes.length, encoded.length, 0];
    const local = record([LOCAL, 20, ...common], `42${COMMON}`);
    parts.push(local, encoded, bytes);
    directory.push(record([CENTRAL, 20, 20, ...common, 0, 0, 0, 0, offset], `422${COMMON}22244`), encoded);
    offset += local.length + encoded.length + bytes.length;
  }
  const size = directory.reduce((total, { length }) => total + length, 0);
  const end = record([END, 0, 0, files.length, files.length, size, offset, 0], "42222442");
  return new Blob([...parts, ...directory, end], { type: "application/zip" });
}

/** Numbers, little-endian, each as wide as its digit says. @param {readonly number[]} values @param {string} widths */
function record(values, widths) {
  const bytes = new Uint8Array([...widths].reduce((total, width) => total + Number(width), 0));
  const view = new DataView(bytes.buffer);
  let at = 0;
  values.forEach((value, index) => {
    if (widths[index] === "2") view.setUint16(at, value, true);
    else view.setUint32(at, value, true);
    at += Number(widths[index]);
  });
  return bytes;
}
