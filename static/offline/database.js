/**
 * The files that were opened last, in a database of this browser. What is open while the page is loaded again, and what
 * came from outside before the viewer was there, wait in it, too.
 *
 *     await transact("readwrite", (store) => store.put({ files }, HELD));
 *
 * @typedef {{ path: string, file: File }} Found  a file and its path
 * @typedef {{ files: readonly Found[], status?: { version?: number }, history?: { past: readonly object[], future: readonly object[] } }} Held
 *   files that wait, or none where the page's address names the mesh; their settings, and the steps that led there
 */

const DATABASE = "hexalab";
const STORE = "last";

/** Where the last files stand. */
export const FILES = "files";

/** What waits for the viewer to be there; in the session's storage, whether something does. */
export const HELD = "held";
export const MARK = "hexalab.held";

/**
 * @param {IDBTransactionMode} mode @param {(store: IDBObjectStore) => IDBRequest} ask
 * @returns {Promise<unknown>} null where there is nothing
 * @throws {DOMException} where the browser keeps nothing, as in some private windows, or its storage is full
 */
export async function transact(mode, ask) {
  const opening = indexedDB.open(DATABASE, 1);
  opening.onupgradeneeded = () => opening.result.createObjectStore(STORE);
  const database = await answerOf(opening);
  try {
    const transaction = database.transaction(STORE, mode);
    const whole = wholeOf(transaction);
    const [answer] = await Promise.all([answerOf(ask(transaction.objectStore(STORE))), whole]);
    return answer ?? null;
  } finally {
    database.close();
  }
}

/** A request that is answered may still fail to be written, where the storage is full. @param {IDBTransaction} transaction @returns {Promise<void>} */
function wholeOf(transaction) {
  return new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onabort = () =>
      reject(transaction.error ?? new DOMException("it was broken off", "AbortError"));
  });
}

/** @template T @param {IDBRequest<T>} request @returns {Promise<T>} */
function answerOf(request) {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });
}
