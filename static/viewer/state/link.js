import { difference } from "./paths.js";

/**
 * The status in a link's hash: `#status=` and the deflated JSON of what differs from the defaults, in base64url.
 * The hash never reaches a server.
 */

const KEY = "status";

/** @param {object & { version?: unknown }} status @param {object} defaults @returns {Promise<string>} the hash without its # */
export async function statusToHash(status, defaults) {
  const partial = { version: status.version, ...difference(defaults, status) };
  const bytes = await pipe(
    new TextEncoder().encode(JSON.stringify(partial)),
    new CompressionStream("deflate-raw"),
  );
  return `${KEY}=${toBase64Url(bytes)}`;
}

/**
 * @param {string} hash location.hash, with or without its #
 * @returns {Promise<unknown>} the partial document, or null if the hash carries none
 * @throws {Error} if it carries one that can't be read
 */
export async function statusFromHash(hash) {
  const text = new URLSearchParams(hash.replace(/^#/, "")).get(KEY);
  if (!text) return null;
  try {
    const bytes = await pipe(fromBase64Url(text), new DecompressionStream("deflate-raw"));
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch (cause) {
    throw new Error("the link's status can't be read: it seems to have been cut short", { cause });
  }
}

/** @param {Uint8Array} bytes @param {CompressionStream | DecompressionStream} transform */
async function pipe(bytes, transform) {
  const stream = new Blob([/** @type {BlobPart} */ (bytes)]).stream().pipeThrough(transform);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** @param {Uint8Array} bytes */
function toBase64Url(bytes) {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** @param {string} text */
function fromBase64Url(text) {
  const plain = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(plain, (letter) => letter.charCodeAt(0));
}
