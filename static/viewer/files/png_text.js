import { crc32 } from "./crc32.js";
import { inflated } from "./inflate.js";

/**
 * Settings inside pictures (SPEC S3): the status stands in an iTXt chunk with the keyword `hexalab`, as the original
 * application writes it. Reading takes iTXt, zTXt and tEXt, compressed or not.
 */

const KEYWORD = "hexalab";
const TEXTS = ["iTXt", "zTXt", "tEXt"];

/** Bytes of settings that a picture may carry: a list of the cells of a large mesh has room. */
const MOST_BYTES = 2 ** 24;

const SIGNATURE = [137, 80, 78, 71, 13, 10, 26, 10];

/** @typedef {{ type: string, start: number, length: number }} Chunk `start` of the data */

/** @param {Uint8Array} bytes @returns {Chunk[]} @throws {Error} if it is no PNG, or is cut short */
function chunksOf(bytes) {
  if (SIGNATURE.some((byte, at) => bytes[at] !== byte)) throw new Error("this is no PNG picture");
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const chunks = [];
  for (let at = SIGNATURE.length; at + 12 <= bytes.length; ) {
    const length = view.getUint32(at);
    if (at + 12 + length > bytes.length) throw new Error("this PNG picture is cut short");
    chunks.push({ type: latin(bytes.subarray(at + 4, at + 8)), start: at + 8, length });
    at += 12 + length;
  }
  return chunks;
}

/**
 * @param {ArrayBuffer} buffer a PNG file
 * @returns {Promise<string | null>} the settings it carries, or null
 */
export async function readStatus(buffer) {
  const bytes = new Uint8Array(buffer);
  for (const { type, start, length } of chunksOf(bytes)) {
    const data = bytes.subarray(start, start + length);
    if (carriesStatus(type, data)) return textOf(type, data.subarray(KEYWORD.length + 1));
  }
  return null;
}

/** @param {string} type @param {Uint8Array} data of a chunk */
function carriesStatus(type, data) {
  return TEXTS.includes(type) && latin(data.subarray(0, data.indexOf(0))) === KEYWORD;
}

/** @param {string} type @param {Uint8Array} data what follows the keyword and its zero */
async function textOf(type, data) {
  if (type === "tEXt") return latin(data);
  if (type === "zTXt") return latin(await unpacked(data.subarray(1)));
  const language = data.indexOf(0, 2);
  const translated = data.indexOf(0, language + 1);
  const text = data.subarray(translated + 1);
  return new TextDecoder().decode(data[0] ? await unpacked(text) : text);
}

/** Text of a chunk, of which a bomb may come. @param {Uint8Array} bytes */
const unpacked = (bytes) => inflated(bytes, "deflate", { most: MOST_BYTES, name: "the picture's settings" });

/**
 * @param {Blob} picture a PNG
 * @param {string} text the settings, as JSON
 * @returns {Promise<Blob>} the same picture, carrying them in place of those that it carried
 */
export async function writeStatus(picture, text) {
  const bytes = new Uint8Array(await picture.arrayBuffer());
  const chunks = chunksOf(bytes);
  if (chunks.at(-1)?.type !== "IEND") throw new Error("this PNG picture is cut short");
  const parts = [bytes.subarray(0, SIGNATURE.length)];
  for (const { type, start, length } of chunks) {
    if (type === "IEND") parts.push(textChunk(text));
    if (!carriesStatus(type, bytes.subarray(start, start + length)))
      parts.push(bytes.subarray(start - 8, start + length + 4));
  }
  return new Blob(/** @type {BlobPart[]} */ (parts), { type: "image/png" });
}

/** An iTXt chunk: keyword, not compressed, no language, no translated keyword. @param {string} text */
function textChunk(text) {
  const data = new TextEncoder().encode(`iTXt${KEYWORD}\0\0\0\0\0${text}`);
  const chunk = new Uint8Array(data.length + 8);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, data.length - 4);
  chunk.set(data, 4);
  view.setUint32(4 + data.length, crc32(data));
  return chunk;
}

/** @param {Uint8Array} bytes */
function latin(bytes) {
  return new TextDecoder("latin1").decode(bytes);
}
