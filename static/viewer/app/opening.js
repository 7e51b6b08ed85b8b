import { Superseded } from "../core/client.js";
import { unpack } from "../files/packing.js";
import { NEW_MESH } from "../state/facts.js";
import { count, counted } from "../state/numbers.js";

/**
 * @typedef {import("../state/origin.js").Origin} Origin
 * @typedef {import("../state/origin.js").Report} Report
 * @typedef {import("../state/answers.js").Summary} Summary
 * @typedef {import("../state/facts.js").MeshSummary} MeshSummary
 */

/** @param {readonly (readonly number[])[]} box two corners */
const diagonalOf = ([low, high]) => Math.hypot(...high.map((end, axis) => end - low[axis]));

/** @param {Origin} origin @param {MeshSummary} summary */
export const nameOf = (origin, summary) => (origin.offered === undefined ? origin.name : summary.name);

/** @param {File} file @param {string} [name] its path, where a folder was opened @returns {Origin} */
export function fromFile(file, name = file.name) {
  return { name, bytes: () => bytesOf(file) };
}

/** @param {Blob & { name?: string }} file @returns {Promise<ArrayBuffer>} */
export async function bytesOf(file) {
  try {
    return await file.arrayBuffer();
  } catch (cause) {
    const reason = "it was changed, moved or deleted on the disk since it was chosen: choose it again";
    throw new Error(`${file.name ?? "the file"} can't be read any more: ${reason}`, { cause });
  }
}

/** An origin that gives the very bytes that were read, where they are kept. @param {Origin} origin @returns {Origin} */
function asRead(origin) {
  const { kept } = origin;
  return kept ? { ...origin, bytes: () => kept.arrayBuffer() } : origin;
}

/** @param {Origin} origin @param {Report} [report] @returns {Promise<ArrayBuffer | null>} null for what the core has at hand */
async function bytesIn({ bytes }, report = () => {}) {
  return bytes ? bytes(report) : null;
}

/**
 * Opens meshes, one at a time: a newer one takes the place of one that is still being read; a file that can't be read
 * leaves the mesh on the screen as it is.
 */
export class Opening {
  #app;
  #turn = 0;
  /** What is on the screen. @type {Origin | null} */
  #current = null;
  /** What the core holds: another mesh than the screen shows, from when a newer one is asked for until that is there. @type {Origin | null} */
  #held = null;

  /** Settles when the open mesh's SHA-256 is known, or can't be. @type {Promise<void>} */
  identified = Promise.resolve();

  /** @param {import("./side.js").Side} app */
  constructor(app) {
    this.#app = app;
  }

  /**
   * @param {Origin} origin
   * @returns {Promise<Summary>} the mesh's summary
   * @throws {Superseded} if another mesh was opened meanwhile
   * @throws {Error} what could not be read, in words that were also shown
   */
  async open(origin) {
    const { progress, messages, client, scene, ahead, portraits } = this.#app;
    const turn = ++this.#turn;
    const began = performance.now();
    const task = progress.begin(`fetching ${origin.name}`);
    const current = () => {
      if (turn !== this.#turn) throw new Superseded();
    };
    try {
      let needless = () => {};
      const read = /** @type {Promise<null>} */ (new Promise((done) => (needless = () => done(null))));
      const preview = this.#preview(origin, current, read);
      const portrayed = portraits?.begin(origin);
      void preview.then(() => scene.prepare()); // while the core starts
      void Promise.all([preview, portrayed]).then(() => ahead.tellShown());
      const bytes = await bytesIn(origin, (fraction, text) => task.report(fraction, text));
      current();
      task.report(
        null,
        this.#app.facts.get("core") === "ready" ? this.#reading(origin) : "loading the measuring engine",
      );
      await client.ready;
      current();
      task.report(null, this.#reading(origin));
      const summary = await this.#ask(origin, bytes);
      needless();
      if (turn !== this.#turn) this.#app.drawing.pause();
      current();
      const previewed = await preview;
      this.#current = origin;
      if (previewed) messages.settle("open");
      await this.#begin(origin, summary, previewed);
      void portraits?.seen();
      this.#app.note({ ...summary.timings, first_picture: performance.now() - began });
      task.end();
      this.#app.measures.fill();
      this.#app.opened();
      return summary;
    } catch (error) {
      if (!(error instanceof Superseded)) messages.error(error, { topic: "open" });
      if (turn === this.#turn) portraits?.failed();
      if (turn === this.#turn && this.#held !== this.#current) await this.reopen();
      throw error;
    } finally {
      task.end();
    }
  }

  /** Where what is on the screen comes from, to be read again as it was. @returns {Origin | null} */
  get present() {
    return this.#current && asRead(this.#current);
  }

  /** Remember what is open, and its settings: the function that is returned comes back to them. @returns {() => Promise<void>} */
  mark() {
    const origin = this.#current;
    const { status, touched } = this.#app.store;
    const changed = new Set(touched);
    return async () => {
      if (!origin || origin === this.#current) return this.#app.dress({ layers: [status] });
      await this.open({ ...asRead(origin), status: undefined, layers: [status] });
      this.#app.store.touch(changed);
    };
  }

  /** Open the present mesh again: the core was restarted, or holds another. */
  async reopen() {
    if (!this.#current) return;
    const { drawing, measures } = this.#app;
    await this.#ask(this.#current, await (this.#current.kept?.arrayBuffer() ?? bytesIn(this.#current)));
    drawing.begin();
    await drawing.update();
    measures.fill();
    this.#app.opened();
  }

  /** Open what is on the screen as its file is now, under all its settings. @returns {Promise<Summary | null>} null where nothing is open */
  async renew() {
    return this.#current && this.open({ ...this.#current, status: undefined, renewed: true });
  }

  /** @param {Origin} origin @param {ArrayBuffer | null} bytes @returns {Promise<Summary>} */
  async #ask(origin, bytes) {
    const { client } = this.#app;
    const companions = await origin.companions?.();
    const options = { replace: "open" };
    const summary = await (bytes === null
      ? client.call("open_offered", [/** @type {string} */ (origin.offered)], options)
      : client.call("open", companions ? [origin.name, bytes, companions] : [origin.name, bytes], options));
    this.#held = origin;
    this.#app.taken();
    origin.sha256 = origin.entry?.mesh.sha256 ?? "";
    this.identified = client.identity.then((identity) => this.#identify(origin, identity));
    return summary;
  }

  /** The core has hashed what it opened; what it has read is kept for when it has to be started anew. @param {Origin} origin @param {import("../core/client.js").Identity} identity */
  #identify(origin, { sha256, bytes }) {
    if (origin !== this.#held) return;
    if (sha256) origin.sha256 = sha256;
    if (bytes) origin.kept = new Blob([bytes]);
    if (origin === this.#current) this.#app.store.set({ mesh: { sha256: origin.sha256 } }, { undo: false });
  }

  /** @param {Origin} origin */
  #reading(origin) {
    const cells = origin.entry?.mesh.cells;
    return cells ? `reading ${count(cells)} cells` : `reading ${origin.name}`;
  }

  /**
   * Make a mesh the one on the screen.
   *
   * @param {Origin} origin @param {Summary} summary @param {boolean} previewed whether its preview is on the screen already
   */
  async #begin(origin, summary, previewed) {
    const { facts, drawing } = this.#app;
    if (!previewed) this.#enter(origin, summary);
    facts.set({ summary });
    this.#tellMesh(origin, summary);
    drawing.begin();
    await this.#app.dress(origin);
    await drawing.update();
    await drawing.drawn();
  }

  /** Clear away what belonged to the mesh before. @param {Origin} origin @param {MeshSummary} summary */
  #enter(origin, summary) {
    const { facts, scene, drawing } = this.#app;
    const entry = origin.entry ?? null;
    drawing.pause();
    const kept = this.#app.adopt(origin, summary);
    scene.setMesh(summary);
    facts.set({
      ...NEW_MESH,
      summary,
      entry,
      source: entry?.source ?? null,
      address: origin.address ?? "",
      offered: origin.offered ?? null,
    });
    this.#tellView(summary, kept);
  }

  /** Say where one looks, if it is not where one would think. @param {MeshSummary} summary @param {boolean} kept */
  #tellView({ cells, framed_cells: framed, extent, frame }, kept) {
    const { messages, views } = this.#app;
    messages.settleMesh();
    if (kept)
      messages.say("note", "The view of the mesh before was kept", {
        topic: "kept",
        action: { name: "reset", press: () => void views.resetAll() },
      });
    if (framed === cells) return;
    const times = count(Math.round(diagonalOf(extent) / diagonalOf(frame)));
    messages.say(
      "note",
      `The view opens on the largest part, ${counted(framed, "cell")}: the whole is ${times} times as large`,
      {
        topic: "frame",
        action: { name: "fit everything", press: () => views.fitShown() },
      },
    );
  }

  /** @param {Origin} origin @param {Summary} summary */
  #tellMesh(origin, summary) {
    const { sha256 = "" } = origin;
    const name = nameOf(origin, summary);
    this.#app.store.set({ mesh: { name, cells: summary.cells, sha256 } }, { undo: false });
  }

  /**
   * Show a catalogue mesh's preview while the core starts.
   *
   * @param {Origin} origin
   * @param {() => void} current
   * @param {Promise<null>} read when the mesh itself is there: a preview that has not come by then is not waited for
   * @returns {Promise<boolean>} whether it was shown
   */
  async #preview(origin, current, read) {
    const address = origin.entry?.mesh.preview;
    if (!address || this.#app.facts.get("core") === "ready") return false;
    try {
      const bytes = await Promise.race([this.#app.ahead.bytes(address), read]);
      if (bytes === null) return false;
      const packed = /** @type {import("../state/answers.js").Preview} */ (
        /** @type {unknown} */ (unpack(bytes))
      );
      current();
      if (this.#app.facts.get("core") === "ready") return false;
      this.#enter(origin, packed.summary);
      this.#app.drawing.show(packed);
      await this.#app.drawing.drawn();
      this.#app.note({ preview: performance.now() });
      return true;
    } catch {
      return false; // the mesh itself is on its way
    }
  }
}
