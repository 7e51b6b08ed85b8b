/**
 * Numbers by their bytes: all first bytes, then all second ones, and so on. Neighbours are alike in their high bytes, which then
 * stand together, and deflate by a quarter better.
 *
 * @typedef {import("../files/packing.js").TypedArray} TypedArray
 * @typedef {{ planes: Uint8Array, of: string }} Planes
 */

/** @type {Record<string, new (buffer: ArrayBuffer) => TypedArray>} */
const KINDS = { Float32Array, Int32Array, Uint32Array, Int16Array };

/** A record with all its arrays so. @param {unknown} record @returns {unknown} */
export function toPlanes(record) {
  if (Array.isArray(record)) return record.map(toPlanes);
  if (typeof record !== "object" || record === null) return record;
  if (ArrayBuffer.isView(record)) return planesOf(/** @type {TypedArray} */ (record));
  return Object.fromEntries(Object.entries(record).map(([name, part]) => [name, toPlanes(part)]));
}

/** A record as it was. @param {unknown} record @returns {unknown} */
export function fromPlanes(record) {
  if (Array.isArray(record)) return record.map(fromPlanes);
  if (typeof record !== "object" || record === null || ArrayBuffer.isView(record)) return record;
  if ("planes" in record) return arrayOf(/** @type {Planes} */ (record));
  return Object.fromEntries(Object.entries(record).map(([name, part]) => [name, fromPlanes(part)]));
}

/** @param {TypedArray} array @returns {Planes | TypedArray} bytes stay as they are */
function planesOf(array) {
  const of = array.constructor.name;
  if (!(of in KINDS)) return array;
  const bytes = new Uint8Array(array.buffer, array.byteOffset, array.byteLength);
  const planes = new Uint8Array(bytes.length);
  const width = array.BYTES_PER_ELEMENT;
  for (let plane = 0, to = 0; plane < width; plane++)
    for (let from = plane; from < bytes.length; from += width) planes[to++] = bytes[from];
  return { planes, of };
}

/** @param {Planes} record */
function arrayOf({ planes, of }) {
  const bytes = new Uint8Array(planes.length);
  const array = new KINDS[of](bytes.buffer);
  const width = array.BYTES_PER_ELEMENT;
  for (let plane = 0, from = 0; plane < width; plane++)
    for (let to = plane; to < bytes.length; to += width) bytes[to] = planes[from++];
  return array;
}
