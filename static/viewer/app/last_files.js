import { FILES, HELD, MARK, transact } from "../../offline/database.js";
import { statusToHash } from "../state/link.js";

/**
 * The files that were opened last, kept in this browser, so that they can be opened again after a reload: their contents in a
 * database, the settings that they were seen under beside.
 *
 * @typedef {import("./files.js").Found} Found
 */

const STATUS = "hexalab.last-status";

/** Bytes up to which files are kept. */
const MOST = 256 * 2 ** 20;

/** Milliseconds after a change until settings are written. */
const REST = 500;

export class LastFiles {
  #app;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #writing;
  /** What is open, if it came as files. @type {readonly Found[] | null} */
  #open = null;
  /** Whether something was held. @type {Promise<boolean>} */
  #started = Promise.resolve(false);
  /** What could be undone before the page was loaded again. @type {import("../state/store.js").StatusStore["history"] | null} */
  #steps = null;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /** Offer what was open when the page was left, and keep what is opened. */
  async start() {
    const { store, facts } = this.#app;
    store.on("*", () => this.#writeSoon());
    facts.on("remember", (on) => !on && void this.forget());
    this.#started = this.#resume();
    if (await this.#started) return;
    const found = facts.get("remember") ? await this.#read() : null;
    if (!found?.length || facts.get("summary")) return;
    const press = () => this.#again(found);
    facts.set({ again: { name: found[0].path, press } });
  }

  /** @param {readonly Found[]} found */
  async keep(found) {
    this.#open = found;
    this.#app.facts.set({ again: null });
    const size = found.reduce((sum, { file }) => sum + file.size, 0);
    if (!this.#app.facts.get("remember") || size > MOST) return this.forget();
    await this.#transact("readwrite", (store) => store.put([...found], FILES));
    this.#write();
  }

  async forget() {
    clearTimeout(this.#writing);
    this.#app.facts.set({ again: null });
    kept(() => localStorage.removeItem(STATUS));
    await this.#transact("readwrite", (store) => store.delete(FILES));
  }

  /**
   * Hold what is open and its settings while the page is loaded again, whatever its size and whether it may be remembered.
   *
   * @throws {DOMException} where the browser keeps nothing, or its storage is full
   */
  async hold() {
    const { facts, store } = this.#app;
    if (!facts.get("summary")) return;
    const addressed = new URLSearchParams(location.search).has("mesh");
    if (addressed)
      history.replaceState(history.state, "", `#${await statusToHash(store.status, store.defaults)}`);
    else if (!this.#open) throw new Error("it is no file of this machine");
    const files = addressed ? [] : [...(this.#open ?? [])];
    const held = { files, status: store.status, history: store.history };
    try {
      await transact("readwrite", (last) => last.put(held, HELD));
      sessionStorage.setItem(MARK, HELD);
    } catch (error) {
      if (!addressed) throw error; // else the address has all but the steps that can be undone
    }
  }

  /** The mesh that the address names is open: what could be undone before the page was loaded again can be undone again. */
  async recall() {
    await this.#started;
    if (this.#steps) this.#app.store.recall(this.#steps);
    this.#steps = null;
  }

  /** Come back to what was held. @returns {Promise<boolean>} whether something was */
  async #resume() {
    const { store } = this.#app;
    const marked = kept(() => sessionStorage.getItem(MARK)) !== null;
    kept(() => sessionStorage.removeItem(MARK));
    const address = new URL(location.href);
    const sent = address.searchParams.has("held");
    if (!marked && !sent) return false;
    if (sent) {
      address.searchParams.delete("held");
      history.replaceState(history.state, "", address);
    }
    const held = /** @type {import("../../offline/database.js").Held | null} */ (
      await this.#transact("readonly", (store) => store.get(HELD))
    );
    if (!held) return false;
    const { status, history: steps } = held;
    const files = await copied(held.files).catch(() => held.files); // before what they were read from goes
    await this.#transact("readwrite", (store) => store.delete(HELD));
    // A new version may have other settings: then its steps begin here.
    this.#steps =
      steps && status?.version === store.defaults.version
        ? /** @type {import("../state/store.js").StatusStore["history"]} */ (steps)
        : null;
    if (files.length) void this.#again(files, status ?? {}).then(() => this.recall());
    return true;
  }

  /** @param {readonly Found[]} found @param {unknown} [known] its settings, those that were written last without */
  async #again(found, known) {
    const status = known ?? kept(() => JSON.parse(localStorage.getItem(STATUS) ?? "null"));
    const { documents, drawing } = this.#app;
    try {
      await this.#app.openFiles(found);
      if (status) await documents.replaceBy([status]);
      await drawing.update();
    } catch {
      // said in a message by whoever failed
    }
  }

  /** @returns {Promise<Found[] | null>} */
  async #read() {
    return /** @type {Found[] | null} */ (await this.#transact("readonly", (store) => store.get(FILES)));
  }

  #writeSoon() {
    clearTimeout(this.#writing);
    this.#writing = setTimeout(() => this.#write(), REST);
  }

  /** Settings are kept with a file of one's own; of others the address tells. */
  #write() {
    const { facts, store } = this.#app;
    if (!facts.get("remember") || !facts.get("summary") || facts.get("entry")) return;
    kept(() => localStorage.setItem(STATUS, JSON.stringify(store.status)));
  }

  /**
   * @param {IDBTransactionMode} mode @param {(store: IDBObjectStore) => IDBRequest} ask
   * @returns {Promise<unknown>} null where the browser keeps nothing, as in private windows, or its storage is full
   */
  async #transact(mode, ask) {
    try {
      return await transact(mode, ask);
    } catch {
      return null;
    }
  }
}

/** Files that hang on no database. @param {readonly Found[]} files @returns {Promise<Found[]>} */
function copied(files) {
  return Promise.all(
    files.map(async ({ path, file }) => {
      const { name, type, lastModified } = file;
      return { path, file: new File([await file.arrayBuffer()], name, { type, lastModified }) };
    }),
  );
}

/** What a browser may refuse to keep. @template T @param {() => T} act @returns {T | null} */
function kept(act) {
  try {
    return act();
  } catch {
    return null;
  }
}
