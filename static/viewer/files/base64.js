/** Bytes that become text at a time: as many as a call takes arguments. */
const LOT = 32_768;

/** @param {Uint8Array} bytes @returns {string} */
export function toBase64(bytes) {
  const parts = [];
  for (let at = 0; at < bytes.length; at += LOT)
    parts.push(String.fromCharCode(...bytes.subarray(at, at + LOT)));
  return btoa(parts.join(""));
}

/** @param {string} text @returns {Uint8Array<ArrayBuffer>} */
export function fromBase64(text) {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}
