/**
 * A question to the core as transports carry it: the method's arguments as JSON, and beside them the blocks of bytes
 * that they hold, to which `{"$bytes": n}` refers (hexalab.session.door).
 *
 * @typedef {{ id: number, method: string, text: string, blocks: ArrayBuffer[] }} Question
 */

/** @param {number} id @param {string} method @param {readonly unknown[]} args @returns {Question} */
export function question(id, method, args) {
  /** @type {ArrayBuffer[]} */
  const blocks = [];
  const text = JSON.stringify(args, (_, value) =>
    value instanceof ArrayBuffer ? { $bytes: blocks.push(value) - 1 } : value,
  );
  return { id, method, text, blocks };
}
