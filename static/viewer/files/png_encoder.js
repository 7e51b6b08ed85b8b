import { crc32 } from "./crc32.js";

const SIGNATURE = Uint8Array.of(137, 80, 78, 71, 13, 10, 26, 10);

/**
 * @param {string} type four letters
 * @param {Uint8Array} data
 * @returns {Uint8Array<ArrayBuffer>}
 */
function chunk(type, data) {
  const out = new Uint8Array(12 + data.length);
  const view = new DataView(out.buffer);
  view.setUint32(0, data.length);
  for (let k = 0; k < 4; k++) out[4 + k] = type.charCodeAt(k);
  out.set(data, 8);
  view.setUint32(8 + data.length, crc32(out.subarray(4, 8 + data.length)));
  return out;
}

/**
 * A PNG of 8-bit colour with alpha.
 *
 * @param {number} width
 * @param {number} height
 * @param {Uint8ClampedArray} pixels (4 width height), top row first
 * @returns {Promise<Uint8Array<ArrayBuffer>>}
 */
export async function encodePng(width, height, pixels) {
  const header = new Uint8Array(13);
  const view = new DataView(header.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  header.set([8, 6, 0, 0, 0], 8);
  const stream = rows(width, height, pixels).pipeThrough(new CompressionStream("deflate"));
  const packed = new Uint8Array(await new Response(stream).arrayBuffer());
  return joined([
    SIGNATURE,
    chunk("IHDR", header),
    chunk("sRGB", Uint8Array.of(0)),
    chunk("IDAT", packed),
    chunk("IEND", new Uint8Array(0)),
  ]);
}

/**
 * Rows as differences from the row above (filter type 2), some at a time.
 *
 * @param {number} width
 * @param {number} height
 * @param {Uint8ClampedArray} pixels
 * @returns {ReadableStream<Uint8Array<ArrayBuffer>>}
 */
function rows(width, height, pixels) {
  const stride = 4 * width;
  let y = 0;
  return new ReadableStream({
    pull(controller) {
      const count = Math.min(64, height - y);
      const out = new Uint8Array(count * (stride + 1));
      for (let r = 0, to = 0; r < count; r++, y++) {
        out[to++] = y === 0 ? 0 : 2;
        const from = y * stride;
        for (let k = 0; k < stride; k++)
          out[to++] = pixels[from + k] - (y === 0 ? 0 : pixels[from + k - stride]);
      }
      controller.enqueue(out);
      if (y >= height) controller.close();
    },
  });
}

/** @param {Uint8Array[]} parts @returns {Uint8Array<ArrayBuffer>} */
function joined(parts) {
  const out = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    out.set(part, at);
    at += part.length;
  }
  return out;
}
