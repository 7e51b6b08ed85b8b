import { meshesOf, settingsBeside } from "../batch/batch.js";
import { CoreError, Superseded } from "../core/client.js";
import { readStatus } from "../files/png_text.js";
import { readZip } from "../files/zip.js";
import { edgesOf, isDeck, mainOf } from "./decks.js";
import { parse } from "./documents.js";
import { bytesOf, fromFile } from "./opening.js";

/**
 * A file with its path below the folder that was dropped; the name alone for a file that was dropped by itself.
 *
 * @typedef {{ file: File, path: string }} Found
 * @typedef {import("../state/facts.js").MeshSummary} MeshSummary
 * @typedef {import("../files/zip.js").Entry} Entry
 * @typedef {import("./opening.js").Origin} Origin
 */

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

  /** @param {readonly (File | Found)[]} given @returns {Promise<MeshSummary | null>} */
  async open(given) {
    const found = given.map((one) => (one instanceof File ? { file: one, path: one.name } : one));
    const of = (/** @type {string} */ kind) => found.filter(({ file }) => kindOf(file) === kind);
    const layers = (
      await Promise.all([...of("status"), ...of("picture")].map((one) => this.#settingsIn(one)))
    ).flat();
    const [archive] = of("archive");
    if (archive) return this.#openArchive(archive.file, layers);
    const candidates = this.#meshesAmong(of("mesh"), found.length);
    const meshes = await mainOf(candidates.map((one) => ({ ...one, text: () => edgesOf(one.file) })));
    if (meshes.length) return this.#openFirst(meshes, of("mesh"), layers);
    for (const layer of layers) await this.#applied(layer);
    return null;
  }

  /** Files by whose ending they are meshes; where there is but one, it may be called anything. @param {Found[]} files @param {number} given how many came together */
  #meshesAmong(files, given) {
    if (given === 1) return files;
    const known = files.filter(({ path }) => this.#isMesh(path));
    return known.length ? known : files.slice(0, 1);
  }

  /** @param {string} path */
  #isMesh(path) {
    return meshesOf([{ name: path }], this.#app.tables.formats).length > 0;
  }

  /** What a deck may include: all but meshes of other formats. @template {{ path: string }} Some @param {{ path: string }} main @param {Some[]} all @returns {Some[]} */
  #companionsOf(main, all) {
    if (!isDeck(main.path)) return [];
    return all.filter(({ path }) => path !== main.path && (isDeck(path) || !this.#isMesh(path)));
  }

  /** @param {Found[]} meshes those that may be shown, the first of all first @param {Found[]} all @param {object[]} layers */
  async #openFirst([main, ...others], all, layers) {
    const beside = this.#companionsOf(main, all);
    const summary = await this.#app.opening.open({
      ...fromFile(main.file, main.path),
      ...(beside.length ? { companions: () => contents(beside) } : {}),
      ...(layers.length ? { status: laidOver(layers) } : {}),
    });
    if (others.length)
      this.#app.messages.say(
        "note",
        `One mesh is shown at a time: ${main.path} was opened, ${others.length} more left out`,
        { topic: "drop" },
      );
    return summary;
  }

  /** The mesh in an archive; several are offered as a batch. @param {File} file @param {object[]} layers @returns {Promise<MeshSummary | null>} */
  async #openArchive(file, layers) {
    try {
      const buffer = await bytesOf(file);
      const entries = readZip(buffer);
      const parts = entries.map((entry) => ({ ...entry, path: entry.name, text: () => textOf(entry) }));
      const meshes = await mainOf(meshesOf(parts, this.#app.tables.formats));
      if (!meshes.length) throw new Error("the archive holds no mesh");
      if (meshes.length > 1) {
        for (const layer of layers) await this.#applied(layer);
        this.#app.facts.set({ archive: { name: file.name, buffer, count: meshes.length } });
        return null;
      }
      const [mesh] = meshes;
      const all = [...(await settingsBeside(mesh, entries)), ...layers];
      return await this.#app.opening.open(originIn(mesh, this.#companionsOf(mesh, parts), all));
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

  /** @param {Found} found @returns {Promise<object[]>} one, or none */
  async #settingsIn({ file }) {
    try {
      const text = kindOf(file) === "status" ? await file.text() : await readStatus(await bytesOf(file));
      if (text === null) throw new Error(`${file.name} carries no HexaLab settings`);
      return [parse(text, file.name)];
    } catch (error) {
      this.#app.messages.error(error, { topic: "status" });
      return [];
    }
  }
}

/** The one mesh of an archive. @param {Entry} mesh @param {Entry[]} beside @param {unknown[]} layers @returns {Origin} */
function originIn(mesh, beside, layers) {
  const companions = async () =>
    Object.fromEntries(
      await Promise.all(beside.map(async ({ name, read }) => [name, (await read()).buffer])),
    );
  return {
    name: beside.length ? mesh.name : (mesh.name.split("/").pop() ?? mesh.name),
    bytes: async () => (await mesh.read()).buffer,
    ...(layers.length ? { status: laidOver(/** @type {object[]} */ (layers)) } : {}),
    ...(beside.length ? { companions } : {}),
  };
}

/** @param {Entry} entry */
async function textOf(entry) {
  return new TextDecoder("latin1").decode(await entry.read());
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

/** What a file is: settings, a picture that may carry them, an archive, or a mesh. @param {File} file @returns {"status" | "picture" | "archive" | "mesh"} */
function kindOf(file) {
  if (/\.(json|txt)$/i.test(file.name)) return "status";
  if (/\.png$/i.test(file.name)) return "picture";
  if (/\.zip$/i.test(file.name)) return "archive";
  return "mesh";
}
