/**
 * A block as `hexalab.packing` writes it, of a value without arrays.
 *
 * @param {unknown} value
 * @returns {ArrayBuffer}
 */
export function packed(value) {
  const header = new TextEncoder().encode(JSON.stringify(value));
  const block = new Uint8Array(8 + header.length);
  block.set(new TextEncoder().encode("HXB1"));
  new DataView(block.buffer).setUint32(4, header.length, true);
  block.set(header, 8);
  return block.buffer;
}
