/**
 * @typedef {import("../app/files.js").Found} Found
 *
 * @typedef {Pick<FileSystemEntry, "isFile" | "isDirectory" | "name">} Entry
 */

/** So many files of a folder are looked at, and so deep. */
const MOST = 2000;
const DEEPEST = 16;

/**
 * The files that were dropped, those of folders with their paths.
 *
 * @param {DataTransfer} transfer of a drop: it is empty as soon as the event is over, so this begins at once
 * @returns {Promise<{ files: (File | Found)[], more: boolean }>} `more`: whether there were more than are looked at
 */
export async function droppedFiles(transfer) {
  const entries = [...transfer.items].map((item) => item.webkitGetAsEntry?.() ?? null);
  const files = [...transfer.files];
  if (!entries.some((entry) => entry?.isDirectory)) return { files, more: false };
  /** @type {Found[]} */
  const found = [];
  const walk = new Walk(found);
  for (const entry of entries) if (entry) await walk.into(entry, "", 0);
  return { files: found, more: walk.more };
}

class Walk {
  more = false;
  #found;

  /** @param {Found[]} found */
  constructor(found) {
    this.#found = found;
  }

  /** @param {FileSystemEntry} entry @param {string} folder @param {number} depth */
  async into(entry, folder, depth) {
    if (this.#found.length >= MOST || depth > DEEPEST) {
      this.more = true;
      return;
    }
    const path = folder ? `${folder}/${entry.name}` : entry.name;
    if (entry.isFile) {
      const file = await new Promise((resolve, reject) =>
        /** @type {FileSystemFileEntry} */ (entry).file(resolve, reject),
      );
      this.#found.push({ file, path });
      return;
    }
    for (const child of await children(/** @type {FileSystemDirectoryEntry} */ (entry)))
      await this.into(child, path, depth + 1);
  }
}

/** @param {FileSystemDirectoryEntry} folder @returns {Promise<FileSystemEntry[]>} by name */
async function children(folder) {
  const reader = folder.createReader();
  /** @type {FileSystemEntry[]} */
  const all = [];
  for (;;) {
    /** @type {FileSystemEntry[]} */
    const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject)); // a hundred at a time
    if (!some.length) return all.sort((a, b) => a.name.localeCompare(b.name));
    all.push(...some);
  }
}
