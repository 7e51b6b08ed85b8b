/**
 * The form of `hexalab.packing`, read and written: "HXB1", the header's length, a JSON header in which arrays are
 * {dtype, shape, offset}, then the arrays, little-endian, offsets counted from the header's end.
 *
 * @typedef {Float64Array | Float32Array | Int32Array | Uint32Array | Int16Array | Uint16Array | Int8Array | Uint8Array} TypedArray
 *
 * @typedef {{ [name: string]: unknown }} PackedRecord of null, booleans, numbers, texts, typed arrays, lists and records
 */

const MAGIC = "HXB1";

/** @type {Record<string, new (buffer: ArrayBuffer, offset: number, length: number) => TypedArray>} */
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

/** @param {ArrayBuffer} buffer @returns {PackedRecord} whoever asked for it says what it must hold, by a cast */
export function unpack(buffer) {
  const magic = buffer.byteLength < 8 ? "" : new TextDecoder().decode(new Uint8Array(buffer, 0, 4));
  if (magic !== MAGIC)
    throw new Error(`found ${JSON.stringify(magic)} at the start of a packed file, expected ${MAGIC}`);
  const length = new DataView(buffer).getUint32(4, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 8, length)));
  return /** @type {PackedRecord} */ (filled(header, buffer, 8 + length));
}

/** @param {unknown} value @param {ArrayBuffer} buffer @param {number} base @returns {unknown} */
function filled(value, buffer, base) {
  if (Array.isArray(value)) return value.map((one) => filled(one, buffer, base));
  if (typeof value !== "object" || value === null) return value;
  if (describesArray(value)) return arrayAt(value, buffer, base);
  return Object.fromEntries(Object.entries(value).map(([key, one]) => [key, filled(one, buffer, base)]));
}

/** @param {object} value @returns {value is ArrayRow} */
function describesArray(value) {
  return "dtype" in value && "offset" in value && "shape" in value;
}

/** @typedef {{ dtype: string, shape: number[], offset: number }} ArrayRow */

/** @param {ArrayRow} row @param {ArrayBuffer} buffer @param {number} base */
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

const ALIGNMENT = 8;

/** @param {number} size */
const aligned = (size) => Math.ceil(size / ALIGNMENT) * ALIGNMENT;

/** Pack a record; what is no number that JSON holds becomes null. @param {object} record @returns {Uint8Array<ArrayBuffer>} */
export function pack(record) {
  /** @type {{ offset: number, array: TypedArray }[]} */
  const arrays = [];
  let end = 0;
  const described = (/** @type {unknown} */ value) => {
    if (!ArrayBuffer.isView(value)) return value;
    const array = /** @type {TypedArray} */ (value);
    const dtype = Object.keys(ARRAYS).find((name) => array instanceof ARRAYS[name]);
    if (!dtype) throw new Error(`arrays of ${array.constructor.name} can't be packed`);
    const row = { dtype, shape: [array.length], offset: end };
    arrays.push({ offset: end, array });
    end = aligned(end + array.byteLength);
    return row;
  };
  const header = new TextEncoder().encode(JSON.stringify(record, (_, value) => described(value)));
  const length = aligned(8 + header.length) - 8;
  const out = new Uint8Array(8 + length + end);
  out.set(new TextEncoder().encode(MAGIC));
  new DataView(out.buffer).setUint32(4, length, true);
  out.fill(0x20, 8, 8 + length).set(header, 8);
  for (const { offset, array } of arrays)
    out.set(new Uint8Array(array.buffer, array.byteOffset, array.byteLength), 8 + length + offset);
  return out;
}
