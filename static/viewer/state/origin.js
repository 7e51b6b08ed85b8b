/**
 * Where a mesh comes from: `bytes`, which may be called again when the core had to be restarted, or what the core has at hand.
 *
 * @typedef {(fraction: number | null, text?: string) => void} Report
 *
 * @typedef {object} Origin
 * @property {string} name
 * @property {string} [address] that it is fetched from
 * @property {(report: Report) => Promise<ArrayBuffer>} [bytes]
 * @property {string} [offered] what the core has it at hand by
 * @property {boolean} [renewed] whether it is the mesh on the screen, as it is now: all settings stay
 * @property {() => Promise<Record<string, ArrayBuffer>>} [companions] files that it refers to, by their paths
 * @property {string} [sha256] of what was read, once that is known
 * @property {Blob} [kept] what was read, so that it can be read again though the file has changed
 * @property {import("./entry.js").Entry | null} [entry] of the catalogue
 * @property {unknown} [status] partial document to apply with the mesh
 * @property {readonly unknown[]} [layers] documents that make up all settings, in place of those that are there
 */

export {};
