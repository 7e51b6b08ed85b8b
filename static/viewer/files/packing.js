/**
 * Reads what `hexalab.packing` writes: "HXB1", the header's length, a JSON header in which arrays are
 * {dtype, shape, offset}, then the arrays, little-endian, offsets counted from the header's end.
 */

const MAGIC = "HXB1";

/** @type {Record<string, any>} */
const ARRAYS = {
  float64: Float64Array,
  float32: Float32Array,
  int32: Int32Array,
  uint32: Uint32Array,
  int16: Int16Array,
  uint16: Uint16Array,
  int8: Int8Array,
  uint8: Uint8Array,
  bool: Uint8Array,
};

/** @param {ArrayBuffer} buffer @returns {any} */
export function unpack(buffer) {
  const magic = buffer.byteLength < 8 ? "" : new TextDecoder().decode(new Uint8Array(buffer, 0, 4));
  if (magic !== MAGIC)
    throw new Error(`found ${JSON.stringify(magic)} at the start of a packed file, expected ${MAGIC}`);
  const length = new DataView(buffer).getUint32(4, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, length)));
  return filled(header, buffer, 8 + length);
}

/** @param {any} value @param {ArrayBuffer} buffer @param {number} base @returns {any} */
function filled(value, buffer, base) {
  if (Array.isArray(value)) return value.map((one) => filled(one, buffer, base));
  if (typeof value !== "object" || value === null) return value;
  if ("dtype" in value && "offset" in value && "shape" in value) return arrayAt(value, buffer, base);
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, filled(one, buffer, base)]));
}

/** @param {{ dtype: string, shape: number[], offset: number }} row @param {ArrayBuffer} buffer @param {number} base */
function arrayAt({ dtype, shape, offset }, buffer, base) {
  const type = ARRAYS[dtype];
  if (!type)
    throw new Error(
      `found an array of ${dtype} in a packed file, expected one of ${Object.keys(ARRAYS).join(", ")}`,
    );
  return new type(
    buffer,
    base + offset,
    shape.reduce((product, size) => product * size, 1),
  );
}
