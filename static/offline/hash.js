/**
 * SHA-256 of bytes, in hexadecimal digits.
 *
 * @param {BufferSource} bytes
 * @returns {Promise<string>} empty where the page does not come over https: browsers compute none there
 */
export async function sha256(bytes) {
  if (!globalThis.crypto?.subtle) return "";
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  return [...digest].map((byte) => byte.toString(16).padStart(2, "0")).join("");
}
