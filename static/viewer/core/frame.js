/**
 * A question as one body of bytes (hexalab.hosts.frames): four bytes with the length of what follows, JSON, then the blocks
 * that its arguments refer to. Nothing is copied.
 *
 * @param {import("./question.js").Question} question
 * @returns {Blob}
 */
export function framed({ id, method, text, blocks }) {
  const sizes = blocks.map((block) => block.byteLength);
  const head = new TextEncoder().encode(JSON.stringify({ id, method, text, sizes }));
  return new Blob([Uint32Array.of(head.length), head, ...blocks]);
}
