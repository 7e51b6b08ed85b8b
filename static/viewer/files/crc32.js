/**
 * Eight tables of 256: the code of a byte that k more bytes follow. With them eight bytes are taken at a time (M. E.
 * Kounavis, F. L. Berry, "A systematic approach to building high performance software-based CRC generators", 2005).
 */
const TABLES = new Uint32Array(8 * 256);
for (let n = 0; n < 256; n++) {
  let code = n;
  for (let bit = 0; bit < 8; bit++) code = code & 1 ? 0xedb88320 ^ (code >>> 1) : code >>> 1;
  TABLES[n] = code;
}
for (let n = 256; n < TABLES.length; n++) TABLES[n] = TABLES[TABLES[n - 256] & 255] ^ (TABLES[n - 256] >>> 8);

/**
 * The cyclic redundancy code of PNG (the specification's annex D) and ZIP.
 *
 * @param {Uint8Array} bytes
 * @returns {number}
 */
export function crc32(bytes) {
  let code = -1;
  let at = 0;
  for (const last = bytes.length - 7; at < last; at += 8) {
    code ^= bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16) | (bytes[at + 3] << 24);
    code =
      TABLES[1792 + (code & 255)] ^
      TABLES[1536 + ((code >>> 8) & 255)] ^
      TABLES[1280 + ((code >>> 16) & 255)] ^
      TABLES[1024 + (code >>> 24)] ^
      TABLES[768 + bytes[at + 4]] ^
      TABLES[512 + bytes[at + 5]] ^
      TABLES[256 + bytes[at + 6]] ^
      TABLES[bytes[at + 7]];
  }
  for (; at < bytes.length; at++) code = TABLES[(code ^ bytes[at]) & 255] ^ (code >>> 8);
  return ~code >>> 0;
}
