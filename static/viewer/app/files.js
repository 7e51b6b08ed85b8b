import { meshesIn, meshesOf, originIn, settingsBeside } from "../batch/archive.js";
import { CoreError, Superseded } from "../core/client.js";
import { includedIn, wholes } from "../files/decks.js";
import { readStatus } from "../files/png_text.js";
import { readZip } from "../files/zip.js";
import { parse } from "./documents.js";
import { bytesOf, fromFile } from "./opening.js";

/**
 * A file with its path below the folder that was dropped; the name alone for a file that was dropped by itself.
 *
 * @typedef {{ file: File, path: string }} Found
 * @typedef {import("../state/facts.js").MeshSummary} MeshSummary
 */

/** @template {import("../files/decks.js").Named} Some @typedef {import("../files/decks.js").Whole<Some>} Whole */

/**
 * Opens what was dropped or chosen together: settings and pictures that carry them apply to the mesh that comes with them;
 * decks that include others are opened with these; an archive's mesh under the archive's settings, over which those that
 * were dropped beside it are laid. Of several meshes the first is shown; several in an archive are offered as a batch.
 */
export class Files {
  #app;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /** @param {readonly Found[]} found @returns {Promise<MeshSummary | null>} */
  async open(found) {
    const kinds = new Map(await Promise.all(found.map(async (one) => kindOf(one))));
    const meshes = await wholes(found, this.#isMesh, ({ file, path }) => includedIn(file, path));
    const parts = new Set(meshes.flatMap((one) => one.parts));
    const of = (/** @type {string} */ kind) =>
      found.filter((one) => kinds.get(one) === kind && !parts.has(one));
    const layers = (
      await Promise.all(
        [...of("status"), ...of("picture")].map((one) => this.#settingsIn(one, kinds.get(one) === "status")),
      )
    ).flat();
    const [archive] = of("archive");
    if (archive) return this.#openArchive(archive.file, layers);
    const unnamed = of("mesh")
      .slice(0, 1)
      .map((mesh) => ({ mesh, parts: [] }));
    const [first, ...others] = meshes.length ? meshes : unnamed; // without a known ending, it may be called anything
    if (first) return this.#openFirst(first, { others, layers, named: meshes.length > 0, found });
    for (const layer of layers) await this.#applied(layer);
    return null;
  }

  /** @param {string} path */
  #isMesh = (path) => meshesOf([{ name: path }], this.#app.tables.formats).length > 0;

  /**
   * Offer a picture and the measurements of each of these, or of each in the archive among them.
   *
   * @param {readonly Found[]} found
   */
  async offerBatch(found) {
    const [archive] = found.filter(({ path }) => /\.zip$/i.test(path));
    try {
      const entries = archive
        ? readZip(await bytesOf(archive.file))
        : found.map(({ file, path }) => ({
            name: path,
            read: async () => new Uint8Array(await bytesOf(file)),
          }));
      const { length: count } = await meshesIn(entries, this.#app.tables.formats);
      if (!count) throw new Error(`there is no mesh among them. ${this.#whatIsRead}`);
      const name = archive?.path ?? `${found.length} files`;
      this.#app.facts.set({ archive: { name, entries, count } });
    } catch (error) {
      this.#app.messages.error(error, { topic: "open" });
    }
  }

  /**
   * @param {Whole<Found>} first
   * @param {{ others: Whole<Found>[], layers: object[], named: boolean, found: readonly Found[] }} among meshes and settings that
   *   came with it; whether it is called a mesh; all that came
   */
  async #openFirst({ mesh, parts }, { others, layers, named, found }) {
    const { opening, messages } = this.#app;
    try {
      const summary = await opening.open({
        ...fromFile(mesh.file, mesh.path),
        ...(parts.length ? { companions: () => contents(parts) } : {}),
        ...(layers.length ? { status: laidOver(layers) } : {}),
      });
      if (others.length)
        messages.say(
          "note",
          `One mesh is shown at a time: ${mesh.path} was opened, ${others.length} more left out`,
          {
            topic: "drop",
            action: { name: "pictures of all", press: () => void this.offerBatch(found) },
          },
        );
      return summary;
    } catch (error) {
      if (!named && error instanceof CoreError)
        messages.say("error", `${error.message}. ${this.#whatIsRead}`, { topic: "open" });
      throw error;
    }
  }

  get #whatIsRead() {
    return "Read are meshes, settings (.json), pictures that were saved here (.png), and archives of meshes (.zip)";
  }

  /** The mesh in an archive; several are offered as a batch. @param {File} file @param {object[]} layers @returns {Promise<MeshSummary | null>} */
  async #openArchive(file, layers) {
    try {
      const entries = readZip(await bytesOf(file));
      const [first, ...others] = await meshesIn(entries, this.#app.tables.formats);
      if (!first) throw new Error("the archive holds no mesh");
      if (others.length) {
        for (const layer of layers) await this.#applied(layer);
        this.#app.facts.set({ archive: { name: file.name, entries, count: others.length + 1 } });
        return null;
      }
      const all = [...(await settingsBeside(first.mesh, entries)), ...layers];
      return await this.#app.opening.open({
        ...originIn(first),
        ...(all.length ? { status: laidOver(/** @type {object[]} */ (all)) } : {}),
      });
    } catch (error) {
      if (error instanceof Superseded || error instanceof CoreError) throw error;
      this.#app.messages.say("error", `${file.name}: ${error instanceof Error ? error.message : error}`, {
        topic: "open",
      });
      return null;
    }
  }

  /** @param {object} status */
  async #applied(status) {
    try {
      await this.#app.documents.apply(status);
    } catch (error) {
      this.#app.messages.error(error, { topic: "status" });
    }
  }

  /** @param {Found} found @param {boolean} isText else a picture that may carry them @returns {Promise<object[]>} one, or none */
  async #settingsIn({ file }, isText) {
    try {
      const text = isText ? await file.text() : await readStatus(await bytesOf(file));
      if (text === null)
        throw new Error(`${file.name} is a picture that carries no settings of HexaLab. ${this.#whatIsRead}`);
      const document = parse(text, file.name);
      const names = Object.keys(document);
      const { version: _, mesh: __, ...sections } = this.#app.store.defaults;
      const known = [...Object.keys(sections), ...ORIGINAL];
      if (names.length && !names.some((name) => name === "mesh" || known.includes(name)))
        throw new Error(
          `${file.name} holds no settings of HexaLab: found ${names.slice(0, 3).join(", ")}, expected some of ${Object.keys(sections).join(", ")}`,
        );
      return [document];
    } catch (error) {
      this.#app.messages.error(error, { topic: "status" });
      return [];
    }
  }
}

/** Files that came by themselves, and with their paths, alike. @param {readonly (File | Found)[]} given @returns {Found[]} */
export function foundOf(given) {
  return given.map((one) => (one instanceof File ? { file: one, path: one.name } : one));
}

/** @param {Found[]} files @returns {Promise<Record<string, ArrayBuffer>>} */
async function contents(files) {
  return Object.fromEntries(
    await Promise.all(files.map(async ({ file, path }) => [path, await bytesOf(file)])),
  );
}

/** Partial documents as one, the last on top. @param {object[]} layers */
function laidOver(layers) {
  return layers.length === 1 ? layers[0] : layers.reduce((below, above) => merged(below, above), {});
}

/** @param {any} below @param {any} above @returns {any} */
function merged(below, above) {
  const both = [below, above].every((one) => one && typeof one === "object" && !Array.isArray(one));
  if (!both) return above;
  const out = { ...below };
  for (const [key, value] of Object.entries(above))
    out[key] = key in below ? merged(below[key], value) : value;
  return out;
}

/** Sections of the original's settings that ours have not. */
const ORIGINAL = ["app", "rendering", "materials"];

/**
 * What a file is: settings, a picture that may carry them, an archive, or else a mesh. A text may be either.
 *
 * @param {Found} found
 * @returns {Promise<[Found, "status" | "picture" | "archive" | "mesh"]>}
 */
async function kindOf(found) {
  const { file } = found;
  if (/\.json$/i.test(file.name)) return [found, "status"];
  if (/\.txt$/i.test(file.name)) {
    const start = await file
      .slice(0, 256)
      .text()
      .catch(() => "");
    return [found, /^\s*\{/.test(start) ? "status" : "mesh"];
  }
  if (/\.png$/i.test(file.name)) return [found, "picture"];
  if (/\.zip$/i.test(file.name)) return [found, "archive"];
  return [found, "mesh"];
}
