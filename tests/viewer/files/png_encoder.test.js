import assert from "node:assert/strict";
import { test } from "node:test";
import { crc32, inflateSync } from "node:zlib";

import { encodePng } from "../../../static/viewer/files/png_encoder.js";

/** Pixels of a PNG of 8-bit RGBA whose rows are filtered by nothing or by the row above. @param {Uint8Array} bytes */
function decode(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const parts = [];
  let size = [0, 0];
  for (let at = 8; at < bytes.length; ) {
    const length = view.getUint32(at);
    const type = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    const data = bytes.subarray(at + 8, at + 8 + length);
    if (crc32) assert.equal(view.getUint32(at + 8 + length), crc32(bytes.subarray(at + 4, at + 8 + length)));
    if (type === "IHDR") size = [view.getUint32(at + 8), view.getUint32(at + 12)];
    if (type === "IDAT") parts.push(data);
    at += 12 + length;
  }
  const raw = inflateSync(Buffer.concat(parts));
  const stride = 4 * size[0];
  const out = new Uint8Array(stride * size[1]);
  for (let y = 0; y < size[1]; y++) {
    const filter = raw[y * (stride + 1)];
    for (let k = 0; k < stride; k++) {
      const above = filter === 2 ? out[(y - 1) * stride + k] : 0;
      out[y * stride + k] = raw[y * (stride + 1) + 1 + k] + above;
    }
  }
  return { size, out };
}

test("S5: the pixels of a written PNG are those given, whatever its size", async () => {
  for (const [width, height] of [
    [1, 1],
    [3, 200],
    [257, 65],
  ]) {
    const pixels = Uint8ClampedArray.from({ length: 4 * width * height }, (_, k) => (k * 2654435761) >>> 24);
    const { size, out } = decode(await encodePng(width, height, pixels));
    assert.deepEqual(size, [width, height]);
    assert.deepEqual(out, new Uint8Array(pixels));
  }
});
