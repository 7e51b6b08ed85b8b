/**
 * Undo a compression within bounds: what comes out is counted, whatever the data say of their size.
 *
 * @param {Uint8Array} bytes
 * @param {"deflate" | "deflate-raw"} format zlib's, or bare
 * @param {{ most: number, name: string }} options `most`: bytes that may come out; `name`: for errors
 * @returns {Promise<Uint8Array<ArrayBuffer>>}
 * @throws {Error} the data are broken, or more comes out
 */
export async function inflated(bytes, format, { most, name }) {
  const stream = new Blob([/** @type {BlobPart} */ (bytes)])
    .stream()
    .pipeThrough(new DecompressionStream(format));
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const parts = [];
  let total = 0;
  const reader = stream.getReader();
  for (;;) {
    const { done, value } = await next(reader, name);
    if (done) return new Uint8Array(await new Blob(parts).arrayBuffer());
    total += value.length;
    if (total > most) {
      await reader.cancel();
      throw new Error(`${name}: more than ${most / 2 ** 20} MB when unpacked`);
    }
    parts.push(/** @type {Uint8Array<ArrayBuffer>} */ (value));
  }
}

/** @param {ReadableStreamDefaultReader<Uint8Array>} reader @param {string} name */
async function next(reader, name) {
  try {
    return await reader.read();
  } catch (cause) {
    throw new Error(`${name}: what is compressed there is broken`, { cause });
  }
}
