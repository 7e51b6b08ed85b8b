import assert from "node:assert/strict";
import { test } from "node:test";
import { crc32 } from "../../../static/viewer/files/crc32.js";

/** Bit by bit, as the PNG specification's annex D defines it. @param {Uint8Array} bytes */
function defined(bytes) {
  let code = 0xffffffff;
  for (const byte of bytes)
    for (let bit = 0; bit < 8; bit++) {
      const odd = (code ^ (byte >>> bit)) & 1;
      code = odd ? 0xedb88320 ^ (code >>> 1) : code >>> 1;
    }
  return (code ^ 0xffffffff) >>> 0;
}

test("the code of any length and place is what the specification defines", () => {
  assert.equal(crc32(new TextEncoder().encode("123456789")), 0xcbf43926);
  const bytes = Uint8Array.from({ length: 1100 }, (_, at) => (at * 2654435761) >>> 13);
  for (let length = 0; length < 40; length++) {
    const part = bytes.subarray(length % 7, (length % 7) + length);
    assert.equal(crc32(part), defined(part));
  }
  assert.equal(crc32(bytes), defined(bytes));
});
