import { plain } from "../state/plain.js";

/**
 * @typedef {import("../state/answers.js").Rejection} Rejection
 * @typedef {import("../state/entry.js").Index} Index
 * @typedef {import("../state/status.js").PartialStatus} PartialStatus
 * @typedef {NonNullable<PartialStatus["mesh"]>} Identity  of a mesh
 */

/**
 * Settings documents that come from outside: files, pictures, the clipboard, a link, the editor, scripts. The core
 * checks each; what is wrong is named and the rest applies.
 */
export class Documents {
  #app;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /**
   * @param {unknown} document whole or partial, ours or the original's
   * @returns {Promise<Rejection[]>} what could not be applied
   */
  async apply(document) {
    const { store, facts } = this.#app;
    const given = plain(document);
    const { mesh, other, settings, rejections } = await this.#checked(given);
    store.seal();
    store.set(settings, {});
    store.seal();
    const catalogue = facts.get("catalogue");
    const { status } = store;
    if (mesh && !isSame(mesh, status.mesh)) this.#offer(mesh, other, given, catalogue);
    else if (other?.name && !isSame(other, status.compare.other)) this.#offerBeside(other, catalogue);
    return rejections;
  }

  /**
   * Make the settings those that the open mesh has of its own, with these documents laid over them, one after the other: nothing that was set before
   * stays.
   *
   * @param {readonly unknown[]} layers
   */
  async replaceBy(layers) {
    const { store, views } = this.#app;
    const { mesh: _, version: __, ...settings } = views.own;
    store.set(settings, { undo: false });
    for (const layer of layers) store.set((await this.#checked(plain(layer))).settings, { undo: false });
    store.seal();
  }

  /** What of a document can be applied; what is wrong with the rest is told. @param {unknown} document */
  async #checked(document) {
    const { client, messages } = this.#app;
    await client.ready;
    const { partial, rejections } = await client.call("check", [document]);
    const { mesh, compare: { other, ...compare } = {}, ...rest } = partial;
    const settings = Object.keys(compare).length ? { ...rest, compare } : rest;
    messages.settle("status");
    if (rejections.length) messages.say("warning", rejectionsInWords(rejections), { topic: "status" });
    return { mesh, other, settings, rejections };
  }

  /** The same from text. @param {string} text @param {string} from what the text is, for the message */
  async applyText(text, from) {
    try {
      return await this.apply(parse(text, from));
    } catch (error) {
      this.#app.messages.error(error, { topic: "status" });
      return null;
    }
  }

  /** The present status as a document. */
  text() {
    return documentText(this.#app.store.status);
  }

  /** Offer the meshes that the settings were made with, if the catalogue has them. @param {Identity} mesh @param {Identity | undefined} other @param {unknown} document @param {Index | null} catalogue */
  #offer(mesh, other, document, catalogue) {
    const entry = catalogue?.identified(mesh);
    if (!entry) return;
    const beside = other?.name ? catalogue?.identified(other) : null;
    const press = async () => {
      await this.#app.chooseEntry(entry.source.slug, entry.mesh.slug, document);
      if (beside) await this.#app.comparing.openEntry(beside.source.slug, beside.mesh.slug).catch(() => {}); // said in a message
    };
    const names = beside ? `${entry.mesh.name} and ${beside.mesh.name}` : entry.mesh.name;
    this.#app.messages.say("note", `These settings were made with ${names} of the catalogue`, {
      topic: "offer",
      action: { name: beside ? "open them" : "open it", press },
    });
  }

  /** The same of a second mesh alone. @param {Identity} other @param {Index | null} catalogue */
  #offerBeside(other, catalogue) {
    const entry = catalogue?.identified(other);
    if (!entry) return;
    const press = () => this.#app.comparing.openEntry(entry.source.slug, entry.mesh.slug).catch(() => {}); // said in a message
    const text = `These settings were made in a comparison with ${entry.mesh.name} of the catalogue`;
    this.#app.messages.say("note", text, { topic: "offer", action: { name: "open it beside", press } });
  }
}

/** Whether it is the mesh that is open. @param {Identity} mesh @param {import("../state/status.js").Status["mesh"]} open */
function isSame(mesh, open) {
  return mesh.sha256 && open.sha256
    ? mesh.sha256 === open.sha256
    : mesh.name === open.name && mesh.cells === open.cells;
}

/**
 * A status as text: version and mesh first, lists of numbers in one line.
 *
 * @param {object & { version?: unknown, mesh?: unknown }} status
 */
export function documentText({ version, mesh, ...settings }) {
  const text = JSON.stringify({ version, mesh, ...settings }, null, 2);
  const inOneLine = text.replace(
    /\[\n\s+([^[\]{}]*?)\n\s+\]/g,
    (_, list) => `[${list.replace(/\n\s+/g, " ")}]`,
  );
  return `${inOneLine}\n`;
}

/** @param {string} text @param {string} from @returns {object} */
export function parse(text, from) {
  try {
    const document = JSON.parse(text);
    if (typeof document === "object" && document !== null && !Array.isArray(document)) return document;
  } catch (cause) {
    throw new Error(`${from} holds no settings: it is not JSON (${/** @type {Error} */ (cause).message})`, {
      cause,
    });
  }
  throw new Error(`${from} holds no settings: found ${text.trim().slice(0, 20)}, expected an object`);
}

/** @param {readonly Rejection[]} rejections */
export function rejectionsInWords(rejections) {
  const named = rejections
    .slice(0, 3)
    .map(({ path, found, expected }) => `${path || "the document"}: found ${found}, expected ${expected}`);
  const more = rejections.length > 3 ? `; and ${rejections.length - 3} more` : "";
  return `${named.join("; ")}${more}. The rest was applied.`;
}
