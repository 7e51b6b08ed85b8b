import { cacheNames } from "./names.js";

/**
 * The meshes that this browser keeps for when there is no network: those that were opened, up to a limit, the oldest going
 * first.
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
 */

/** Headers in which a row lies beside its mesh. */
const NAME = "x-hexalab-name";
const SIZE = "x-hexalab-size";
const SHA256 = "x-hexalab-sha256";
const DATE = "x-hexalab-date";

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
      const response = await (await caches.open(this.#cache)).match(address);
      return response ? { row: rowOf(address, response), response } : null;
    } catch {
      return null; // a browser that keeps nothing
    }
  }

  /** Everything that is here, the newest first. @returns {Promise<Row[]>} */
  async list() {
    if (!this.works) return [];
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
   * @param {string} address @param {Blob} file @param {{ name: string, sha256?: string }} facts
   * @returns {Promise<boolean>} whether it is here now: not, where it is larger than the limit
   * @throws {DOMException} the browser's storage is full
   */
  async put(address, file, { name, sha256 = "" }) {
    if (!this.works || file.size > this.limit) return false;
    const headers = {
      "content-type": "application/octet-stream",
      [NAME]: encodeURIComponent(name),
      [SIZE]: String(file.size),
      [SHA256]: sha256,
      [DATE]: new Date().toISOString(),
    };
    const cache = await caches.open(this.#cache);
    const put = () => cache.put(address, new Response(file, { headers }));
    try {
      await put();
    } catch (error) {
      if (!(await this.#dropOldest())) throw error;
      await put();
    }
    await this.trim();
    return true;
  }

  /** @param {string} address */
  async remove(address) {
    await (await caches.open(this.#cache)).delete(address);
  }

  /** Let the oldest go until what was opened is within the limit. */
  async trim() {
    let size = 0;
    for (const row of await this.list()) {
      size += row.size;
      if (size > this.limit) await this.remove(row.address);
    }
  }

  /** @returns {Promise<boolean>} whether there was one that may go */
  async #dropOldest() {
    const oldest = (await this.list()).at(-1);
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
  };
}
