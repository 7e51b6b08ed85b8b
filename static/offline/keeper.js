import { download } from "./download.js";
import { sha256 } from "./hash.js";
import { cacheNames } from "./names.js";
import { isRecent, Shelf } from "./shelf.js";
import { inertDocument } from "./trusted.js";

/**
 * Fetches parcels and keeps them until they are freed.
 *
 *     const keeper = new Keeper(root);
 *     const { failed } = await keeper.keep(parcel, { signal, report: (done, of, bytes) => ... });
 *     await keeper.state(parcel);   // { meshes: 12, of: 12, bytes: 4200000 }
 *     await keeper.free(parcel);
 *
 * @typedef {import("./parcel.js").Parcel} Parcel
 * @typedef {import("./parcel.js").Item} Item
 * @typedef {object} Run
 * @property {AbortSignal} signal
 * @property {(done: number, of: number, bytes: number) => void} report files, and bytes that have come
 */

/** Files that are fetched side by side. */
const AT_ONCE = 3;

/** There is no room for more: what has come stays. */
export class StorageFull extends Error {}

export class Keeper {
  #root;
  #shelf;
  #cache;

  /** @param {URL} root of the site */
  constructor(root) {
    this.#root = root.href;
    this.#shelf = new Shelf(root);
    this.#cache = cacheNames(root.href).kept;
  }

  /** How much of a parcel is kept. @param {Parcel} parcel @returns {Promise<{ meshes: number, of: number, bytes: number }>} */
  async state({ meshes }) {
    const rows = new Map((await this.#shelf.list()).map((row) => [row.address, row]));
    const kept = meshes.map(({ address }) => rows.get(address)).filter((row) => row?.kept);
    return {
      meshes: kept.length,
      of: meshes.length,
      bytes: kept.reduce((sum, row) => sum + (row?.size ?? 0), 0),
    };
  }

  /**
   * Fetch what is not here yet. What can't be fetched is left out and named.
   *
   * @param {Parcel} parcel @param {Run} run
   * @returns {Promise<{ failed: string[] }>} why, of each that could not be kept
   * @throws {StorageFull} @throws {DOMException} it was cancelled
   */
  async keep({ meshes, pages, previews }, { signal, report }) {
    /** @type {string[]} */
    const failed = [];
    /** @type {Map<string, number>} */
    const come = new Map();
    let done = 0;
    const of = meshes.length + pages.length + previews.length;
    const tell = () =>
      report(
        done,
        of,
        [...come.values()].reduce((sum, bytes) => sum + bytes, 0),
      );
    const run = (/** @type {() => Promise<void>} */ fetching) => async () => {
      try {
        await fetching();
      } catch (error) {
        if (signal.aborted || error instanceof StorageFull) throw error;
        failed.push(error instanceof Error ? error.message : String(error));
      }
      done += 1;
      tell();
    };
    const tasks = [
      ...meshes.map((item) =>
        run(() =>
          this.#mesh(item, signal, (bytes) => {
            come.set(item.address, bytes);
            tell();
          }),
        ),
      ),
      ...pages.map((address) => run(() => this.#page(address, signal))),
      ...previews.map((address) => run(() => this.#part(address, signal))),
    ];
    tell();
    await sideBySide(tasks);
    return { failed };
  }

  /** Let a parcel go, in whole. @param {Parcel} parcel */
  async free({ meshes, pages, previews }) {
    for (const { address } of meshes) await this.#shelf.remove(address);
    const cache = await caches.open(this.#cache);
    const pictures = await Promise.all(pages.map((address) => this.#shownOn(cache, address)));
    for (const address of [...pages, ...previews, ...pictures.flat()]) await cache.delete(address);
  }

  /** @param {Item} item @param {AbortSignal} signal @param {(bytes: number) => void} report */
  async #mesh({ address, name, sha256: known }, signal, report) {
    const found = await this.#shelf.find(address);
    if (found && (known ? found.row.sha256 === known : isRecent(found.row))) {
      await keeping(() => this.#shelf.keep(address, true));
      return;
    }
    const bytes = await download(address, (_fraction, _text, size) => report(size ?? 0), { signal });
    const sum = await sha256(bytes);
    if (known && sum && sum !== known)
      throw new Error(
        `${name} is not kept: its content is not what the catalogue knows (SHA-256 ${sum.slice(0, 12)}…)`,
      );
    await keeping(() => this.#shelf.put(address, new Blob([bytes]), { name, sha256: sum, kept: true }));
  }

  /** A page and what it shows. @param {string} address @param {AbortSignal} signal */
  async #page(address, signal) {
    await this.#part(address, signal);
    const pictures = await this.#shownOn(await caches.open(this.#cache), address);
    for (const picture of pictures) await this.#part(picture, signal);
  }

  /** @param {string} address @param {AbortSignal} signal */
  async #part(address, signal) {
    const response = await fetch(address, { signal, cache: "no-cache" });
    if (!response.ok)
      throw new Error(`${pathOf(address)} could not be fetched: ${response.status} ${response.statusText}`);
    const cache = await caches.open(this.#cache);
    await keeping(() => cache.put(address, response));
  }

  /** Pictures of this site and files of citations that a kept page names. @param {Cache} cache @param {string} page @returns {Promise<string[]>} */
  async #shownOn(cache, page) {
    const text = await (await cache.match(page))?.text();
    if (!text) return [];
    const shown = inertDocument(text);
    const named = [
      ...[...shown.querySelectorAll("img[src]")].map((one) => one.getAttribute("src")),
      ...[...shown.querySelectorAll(".downloads a[download]")].map((one) => one.getAttribute("href")),
    ];
    const addresses = named.map((address) => new URL(address ?? "", page).href);
    return [...new Set(addresses)].filter((address) => address.startsWith(this.#root));
  }
}

/** When one fails, no other is begun; what is under way ends first. @param {readonly (() => Promise<void>)[]} tasks */
async function sideBySide(tasks) {
  const left = [...tasks];
  const worker = async () => {
    try {
      for (let task = left.shift(); task; task = left.shift()) await task();
    } catch (error) {
      left.length = 0;
      throw error;
    }
  };
  const ends = await Promise.allSettled(Array.from({ length: AT_ONCE }, worker));
  for (const end of ends) if (end.status === "rejected") throw end.reason;
}

/** @param {() => Promise<unknown>} put */
async function keeping(put) {
  try {
    await put();
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") throw error;
    throw new StorageFull("the browser's storage is full", { cause: error });
  }
}

/** @param {string} address */
function pathOf(address) {
  return decodeURIComponent(new URL(address).pathname);
}
