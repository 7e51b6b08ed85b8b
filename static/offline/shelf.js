import { cacheNames } from "./names.js";

/**
 * The meshes that this browser keeps for when there is no network: those that were opened, up to a limit, the oldest going
 * first; and those that are to be kept until they are freed.
 *
 *     const shelf = new Shelf(new URL("../", location.href));
 *     await shelf.put("https://site.example/cube.mesh", new Blob([bytes]), { name: "cube.mesh" });
 *     await (await shelf.find("https://site.example/cube.mesh"))?.response.arrayBuffer();
 *
 * @typedef {object} Row  what is known of a mesh on the shelf
 * @property {string} address
 * @property {string} name
 * @property {number} size bytes
 * @property {string} sha256 of its bytes, or empty
 * @property {Date} date when it was put here
 * @property {boolean} kept whether it stays until it is freed
 */

/** Headers in which a row lies beside its mesh. */
const NAME = "x-hexalab-name";
const SIZE = "x-hexalab-size";
const SHA256 = "x-hexalab-sha256";
const DATE = "x-hexalab-date";
const KEPT = "x-hexalab-kept";

/** Milliseconds for which what is here counts as what its host has. */
const DAY = 24 * 3600e3;

/** Bytes of opened meshes that are kept unless the user chose otherwise. */
export const USUAL_LIMIT = 500e6;

export class Shelf {
  #cache;
  #memory;

  /** @param {URL} root of the site */
  constructor(root) {
    this.#cache = cacheNames(root.href).meshes;
    this.#memory = `${this.#cache} limit`;
  }

  /** Whether this browser can keep anything. */
  get works() {
    return "caches" in globalThis;
  }

  /** Bytes of opened meshes that may be kept. */
  get limit() {
    try {
      const chosen = localStorage.getItem(this.#memory);
      return chosen === null ? USUAL_LIMIT : Number(chosen);
    } catch {
      return USUAL_LIMIT;
    }
  }

  /** @param {number} bytes */
  async setLimit(bytes) {
    localStorage.setItem(this.#memory, String(bytes));
    await this.trim();
  }

  /** @param {string} address @returns {Promise<{ row: Row, response: Response } | null>} */
  async find(address) {
    if (!this.works) return null;
    try {
      if (!(await caches.has(this.#cache))) return null;
      const response = await (await caches.open(this.#cache)).match(address);
      return response ? { row: rowOf(address, response), response } : null;
    } catch {
      return null; // a browser that keeps nothing
    }
  }

  /** Everything that is here, the newest first. @returns {Promise<Row[]>} */
  async list() {
    if (!this.works || !(await caches.has(this.#cache))) return [];
    const cache = await caches.open(this.#cache);
    const rows = await Promise.all(
      (await cache.keys()).map(async ({ url }) => {
        const response = await cache.match(url);
        return response ? [rowOf(url, response)] : [];
      }),
    );
    return rows.flat().sort((a, b) => Number(b.date) - Number(a.date));
  }

  /**
   * Put a mesh here. One that is to be kept stays so when it is put here anew.
   *
   * @param {string} address @param {Blob} file @param {{ name: string, sha256?: string, kept?: boolean }} facts
   * @returns {Promise<boolean>} whether it is here now: not, where it was merely opened and is larger than the limit
   * @throws {DOMException} the browser's storage is full
   */
  async put(address, file, { name, sha256 = "", kept = false }) {
    if (!this.works) return false;
    const stays = kept || Boolean((await this.find(address))?.row.kept);
    if (!stays && file.size > this.limit) return false;
    const headers = {
      "content-type": "application/octet-stream",
      [NAME]: encodeURIComponent(name),
      [SIZE]: String(file.size),
      [SHA256]: sha256,
      [DATE]: new Date().toISOString(),
      [KEPT]: stays ? "1" : "",
    };
    const cache = await caches.open(this.#cache);
    for (;;) {
      try {
        await cache.put(address, new Response(file, { headers }));
        break;
      } catch (error) {
        if (!(await this.#dropOldest(address))) throw error;
      }
    }
    await this.trim();
    return true;
  }

  /** Have a mesh that is here stay until it is freed, or no more. @param {string} address @param {boolean} kept @returns {Promise<boolean>} whether it is here */
  async keep(address, kept) {
    const found = await this.find(address);
    if (!found) return false;
    const headers = new Headers(found.response.headers);
    headers.set(KEPT, kept ? "1" : "");
    const cache = await caches.open(this.#cache);
    await cache.put(address, new Response(await found.response.blob(), { headers }));
    return true;
  }

  /** @param {string} address */
  async remove(address) {
    await (await caches.open(this.#cache)).delete(address);
  }

  /** Let the oldest go until what was merely opened is within the limit. */
  async trim() {
    let size = 0;
    for (const row of await this.#free()) {
      size += row.size;
      if (size > this.limit) await this.remove(row.address);
    }
  }

  /** Those that may go. */
  async #free() {
    return (await this.list()).filter(({ kept }) => !kept);
  }

  /** @param {string} but this one @returns {Promise<boolean>} whether there was one that may go */
  async #dropOldest(but) {
    const oldest = (await this.#free()).filter(({ address }) => address !== but).at(-1);
    if (oldest) await this.remove(oldest.address);
    return Boolean(oldest);
  }
}

/** @param {string} address @param {Response} response @returns {Row} */
function rowOf(address, { headers }) {
  return {
    address,
    name: decodeURIComponent(headers.get(NAME) ?? ""),
    size: Number(headers.get(SIZE) ?? 0),
    sha256: headers.get(SHA256) ?? "",
    date: new Date(headers.get(DATE) ?? 0),
    kept: headers.get(KEPT) === "1",
  };
}

/** Whether a mesh was put here within a day. @param {Row} row */
export function isRecent({ date }) {
  return Date.now() - Number(date) < DAY;
}
