import { crc32 } from "./crc32.js";

/**
 * Settings inside pictures (SPEC S3): the status stands in an iTXt chunk with the keyword `hexalab`, as the original
 * application writes it. Reading takes iTXt, zTXt and tEXt, compressed or not.
 */

const KEYWORD = "hexalab";
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
    if (!["iTXt", "zTXt", "tEXt"].includes(type)) continue;
    const data = bytes.subarray(start, start + length);
    const end = data.indexOf(0);
    if (latin(data.subarray(0, end)) === KEYWORD) return textOf(type, data.subarray(end + 1));
  }
  return null;
}

/** @param {string} type @param {Uint8Array} data what follows the keyword and its zero */
async function textOf(type, data) {
  if (type === "tEXt") return latin(data);
  if (type === "zTXt") return latin(await inflated(data.subarray(1)));
  const language = data.indexOf(0, 2);
  const translated = data.indexOf(0, language + 1);
  const text = data.subarray(translated + 1);
  return new TextDecoder().decode(data[0] ? await inflated(text) : text);
}

/**
 * @param {Blob} picture a PNG
 * @param {string} text the settings, as JSON
 * @returns {Promise<Blob>} the same picture, carrying them
 */
export async function writeStatus(picture, text) {
  const bytes = new Uint8Array(await picture.arrayBuffer());
  const end = chunksOf(bytes).find(({ type }) => type === "IEND");
  if (!end) throw new Error("this PNG picture is cut short");
  const at = end.start - 8;
  return new Blob([bytes.subarray(0, at), /** @type {BlobPart} */ (textChunk(text)), bytes.subarray(at)], {
    type: "image/png",
  });
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

/** @param {Uint8Array} bytes zlib data */
async function inflated(bytes) {
  const stream = new Blob([/** @type {BlobPart} */ (bytes)])
    .stream()
    .pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** @param {Uint8Array} bytes */
function latin(bytes) {
  return new TextDecoder("latin1").decode(bytes);
}
