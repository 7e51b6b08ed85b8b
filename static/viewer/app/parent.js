/**
 * The page around: a page that shows the viewer in a frame asks it by `postMessage`.
 *
 *     frame.contentWindow.postMessage({ hexalab: "setStatus", version: 1, id: 7, args: [{ silhouette: 1 }] }, "https://hexalab.example");
 *
 * brings `{ hexalab: "setStatus", version: 1, id: 7, result: [] }`, or `error` in words in place of `result`; answers come in the
 * order of questions. When the viewer can be asked it posts `{ hexalab: "ready", version: 1, program, methods }`.
 *
 * An embedder that names its origin in the frame's address (`?origin=https://blog.example`) is the only one that is heard, and that
 * is answered. Without, whoever embeds the frame is answered, but is told nothing of a file that the reader has opened in it.
 *
 * @typedef {import("./api.js").HexaLab} HexaLab
 *
 * @typedef {object} Question
 * @property {string} hexalab the method
 * @property {unknown} [version] of the form; the present one without
 * @property {unknown} [id] comes back with the answer
 * @property {unknown} [args]
 */

/** Of the form of questions and answers: grows when one that was right becomes wrong. */
export const VERSION = 1;

/** What may be asked, and whether it tells of the mesh. @type {ReadonlyMap<keyof HexaLab, boolean>} */
const METHODS = new Map([
  ["open", false],
  ["summary", true],
  ["getStatus", true],
  ["setStatus", false],
  ["reset", false],
  ["identified", false],
  ["settled", false],
  ["screenshot", true],
  ["figure", true],
  ["quality", true],
  ["groups", true],
  ["groupStatistics", true],
  ["interfaces", true],
  ["goTo", false],
  ["cells", true],
  ["surface", true],
  ["page", true],
  ["turntable", true],
  ["report", true],
  ["batch", false],
  ["drawn", true],
  ["timings", true],
]);

/** Answers the page around. */
export class Parent {
  #api;
  #facts;
  #origin;
  /** The mesh that the page around has opened last. @type {object | null} */
  #theirs = null;
  /** @type {Promise<void>} */
  #last = Promise.resolve();

  /** @param {HexaLab} api @param {import("../state/facts.js").Facts} facts @param {Location} location */
  constructor(api, facts, location) {
    this.#api = api;
    this.#facts = facts;
    this.#origin = originIn(location.search);
  }

  start() {
    if (parent === window) return;
    window.addEventListener("message", ({ data, source, origin }) => {
      if (source !== parent || typeof data?.hexalab !== "string") return;
      if (this.#origin && origin !== this.#origin) return;
      this.#last = this.#last.then(async () => this.#post(await this.#answer(data)));
    });
    const methods = [...METHODS.keys()];
    const program = this.#api.version;
    this.#api.ready
      .then(() => this.#post({ hexalab: "ready", version: VERSION, program, methods }))
      .catch(() => {});
  }

  /** @param {object} message */
  #post(message) {
    parent.postMessage(message, this.#origin ?? "*");
  }

  /** @param {Question} question */
  async #answer({ hexalab, version = VERSION, id, args = [] }) {
    const told = { hexalab, version: VERSION, id };
    try {
      if (version !== VERSION)
        throw new Error(`version: found ${JSON.stringify(version)}, expected ${VERSION}`);
      const method = [...METHODS.keys()].find((one) => one === hexalab);
      if (!method)
        throw new Error(
          `there is no method ‘${hexalab.slice(0, 60)}’, but ${[...METHODS.keys()].join(", ")}`,
        );
      if (!Array.isArray(args)) throw new Error("args: expected a list of arguments");
      if (METHODS.get(method)) this.#guard();
      const call = /** @type {(...args: unknown[]) => unknown} */ (
        /** @type {unknown} */ (this.#api[method])
      );
      const result = await call.apply(this.#api, args);
      if (method === "open") this.#theirs = this.#facts.get("summary");
      else if (METHODS.get(method)) this.#guard(); // another may have been opened meanwhile
      if (method === "setStatus" && this.#secret) return { ...told, result: pathsOf(result) };
      return { ...told, result };
    } catch (error) {
      return { ...told, error: error instanceof Error ? error.message : String(error) };
    }
  }

  /** Whether the open mesh is a file of the reader's, and the page around has not said who it is. */
  get #secret() {
    const summary = this.#facts.get("summary");
    const known = this.#facts.get("entry") !== null || this.#facts.get("address") !== "";
    return !this.#origin && summary !== null && !known && summary !== this.#theirs;
  }

  /** @throws {Error} nothing may be told of the open mesh */
  #guard() {
    if (!this.#secret) return;
    throw new Error(
      "the open mesh is a file of whoever looks at it: nothing is told of it, unless the frame's address names the page around (origin=https://…)",
    );
  }
}

/** Which settings could not be applied, without what the mesh has in their place. @param {unknown} rejections */
function pathsOf(rejections) {
  return /** @type {import("../state/answers.js").Rejection[]} */ (rejections).map(({ path }) => ({
    path,
    found: "something that the open mesh has not got",
    expected: "something else",
  }));
}

/** The origin that the frame's address names. @param {string} search */
function originIn(search) {
  const named = new URLSearchParams(search).get("origin");
  if (!named) return null;
  try {
    return new URL(named).origin;
  } catch {
    return "https://invalid.invalid"; // nobody is heard under a name that is none
  }
}
