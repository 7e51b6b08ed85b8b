import { CoreError, Superseded } from "../core/client.js";
import { stemOf } from "../files/names.js";
import { writeZip } from "../files/zip.js";
import { meshesIn, originIn, settingsBeside } from "./archive.js";

/**
 * A zip of meshes in, a zip of pictures, histograms and measurements out (SPEC B1). Each is drawn under the defaults with
 * the common status laid over them, and over that the one beside the mesh (`name.json` or `name.txt`), of which nothing
 * stays for the next. A mesh that fails is told in the table; the rest goes on.
 *
 * @typedef {import("../files/zip.js").Entry} Entry
 * @typedef {{ width?: number, height?: number, figures?: boolean, status?: unknown, signal?: AbortSignal,
 *   report?: (done: number, of: number, name: string, failed: number) => void }} Options
 * @typedef {{ width?: number, height?: number }} Size
 * @typedef {Record<string, string | number>} Row  a line of the table
 * @typedef {Record<string, number | null>} Numbers  statistics by name, null where they are none
 * @typedef {{ name: string, problem: string, picture?: string, unit?: string, vertices?: number, cells?: number, boundary_faces?: number,
 *   quality?: Record<string, Numbers> }} Measured  what is told of a mesh: of one that failed, name and problem
 * @typedef {{ name: string, bytes: Uint8Array<ArrayBuffer> }} Made  a file
 * @typedef {import("../state/answers.js").Summary} Summary
 *
 * @typedef {object} Host  what a batch needs of the application
 * @property {Pick<import("../state/store.js").StatusStore, "status" | "touched">} store
 * @property {Pick<import("../state/tables.js").Tables, "formats" | "metrics" | "statistics">} tables
 * @property {Pick<import("../state/facts.js").Facts, "get">} facts
 * @property {Pick<import("../core/client.js").CoreClient, "call">} client
 * @property {{ open: (origin: import("../state/origin.js").Origin) => Promise<Summary>, mark: () => () => Promise<void>, identified: Promise<void> }} opening mark: what
 *   comes back to what is open
 * @property {{ replaceBy: (layers: readonly unknown[]) => Promise<void> }} documents
 * @property {{ drawn: () => Promise<void> }} drawing
 * @property {{ measured: () => Promise<void> }} measures
 * @property {{ settle: (topic: string) => void }} messages
 * @property {{ picture: (size: Size) => Promise<Blob>, figure: (size: Size) => Promise<Blob>, histogram: (format: "png" | "svg") => Promise<Blob | null> }} saving
 */

/** The stem, or with a number added if a mesh of the same stem has it: both have pictures. @param {string} stem @param {Set<string>} names taken ones, in lower case */
function freeName(stem, names) {
  let free = stem;
  for (let number = 2; names.has(free.toLowerCase()); number++) free = `${stem}-${number}`;
  names.add(free.toLowerCase());
  return free;
}

/** @param {readonly Measured[]} all */
function failedOf(all) {
  return all.filter(({ problem }) => problem).map(({ name, problem }) => ({ name, problem }));
}

/** A mesh's line of the table: each statistic of each metric has a column. @param {Measured} measured @returns {Row} */
export function rowOf({ quality = {}, ...facts }) {
  const statistics = Object.entries(quality).flatMap(([id, numbers]) =>
    Object.entries(numbers).map(([name, value]) => [`${id}_${name}`, value ?? ""]),
  );
  return { ...facts, ...Object.fromEntries(statistics) };
}

/** The table as CSV (RFC 4180), all columns that any row has. @param {readonly Row[]} rows */
export function toCsv(rows) {
  const columns = [...new Set(rows.flatMap((row) => Object.keys(row)))];
  const cell = (/** @type {string | number | undefined} */ value) => {
    const text = String(value ?? "");
    return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
  };
  return [columns, ...rows.map((row) => columns.map((column) => row[column]))]
    .map((line) => `${line.map(cell).join(",")}\r\n`)
    .join("");
}

export class Batch {
  #host;

  /** @param {Host} host */
  constructor(host) {
    this.#host = host;
  }

  /**
   * The mesh that was open is open again afterwards, under the settings that it had.
   *
   * @param {Entry[]} entries of an archive, or files
   * @param {Options} [options]
   * @returns {Promise<{ zip: Blob, failed: { name: string, problem: string }[] }>} a zip: NAME.png, NAME-METRIC.png and
   *   NAME-METRIC.svg for each mesh, measurements.csv, measurements.json; and the meshes that failed
   */
  async run(entries, { width, height, figures = false, status, signal, report } = {}) {
    const meshes = await meshesIn(entries, this.#host.tables.formats);
    if (!meshes.length) throw new Error("there is no mesh among them");
    const comeBack = this.#host.opening.mark();
    const common = status ?? this.#present();
    /** @type {Made[]} */
    const files = [];
    /** @type {Measured[]} */
    const all = [];
    const names = new Set();
    try {
      for (const [index, whole] of meshes.entries()) {
        signal?.throwIfAborted();
        report?.(index, meshes.length, whole.mesh.name, failedOf(all).length);
        const stem = freeName(stemOf(whole.mesh.name), names);
        const { measured, made } = await this.portray(whole.mesh.name, stem, originIn(whole), {
          layers: async () => [common, ...(await settingsBeside(whole.mesh, entries))],
          size: { width, height },
          figures,
        });
        all.push(measured);
        files.push(...made);
      }
    } finally {
      await comeBack().catch(() => {}); // which was told
    }
    const failed = failedOf(all);
    report?.(meshes.length, meshes.length, "", failed.length);
    const text = (/** @type {string} */ name, /** @type {string} */ content) =>
      files.push({ name, bytes: new TextEncoder().encode(content) });
    text("measurements.csv", toCsv(all.map(rowOf)));
    text("measurements.json", `${JSON.stringify({ meshes: all }, null, 1)}\n`);
    return { zip: writeZip(files), failed };
  }

  /** The present settings; each mesh is seen in its own view where that was not changed. */
  #present() {
    const { status, touched } = this.#host.store;
    const { camera, filters, ...others } = status;
    return touched.has("camera") || touched.has("filters") ? status : others;
  }

  /**
   * One mesh: what is measured of it, and the files that are made of it.
   *
   * @param {string} name @param {string} stem that its files are called by
   * @param {Omit<import("../state/origin.js").Origin, "layers">} origin
   * @param {{ layers: () => Promise<unknown[]>, size: Size, figures: boolean }} how documents that make up its settings, laid over each other
   * @returns {Promise<{ measured: Measured, made: Made[] }>}
   */
  async portray(name, stem, origin, { layers, size, figures }) {
    const { saving, measures, opening } = this.#host;
    try {
      const { vertices, cells, boundary_faces } = await this.#open(origin, await layers());
      await opening.identified; // which the pictures carry
      if (figures) await measures.measured(); // of which the legend tells
      const picture = `${stem}.png`;
      const made = [await madeOf(picture, await (figures ? saving.figure(size) : saving.picture(size)))];
      await measures.measured();
      const { quantity = "" } = this.#host.facts.get("histogram") ?? {};
      for (const format of /** @type {const} */ (["png", "svg"])) {
        const histogram = await saving.histogram(format);
        if (histogram)
          made.push(await madeOf(`${stem}-${quantity.replace(/[^\w-]+/g, "-")}.${format}`, histogram));
      }
      const quality = await this.#measure();
      const { unit } = this.#host.store.status;
      const named = unit === "none" ? {} : { unit };
      const counts = { vertices, cells, boundary_faces };
      return { measured: { name, problem: "", picture, ...named, ...counts, quality }, made };
    } catch (error) {
      if (error instanceof Superseded)
        throw new Error("the batch was stopped: another mesh was opened", { cause: error });
      if (error instanceof CoreError && error.kind === "WorkerError") throw error;
      return {
        measured: { name, problem: error instanceof Error ? error.message : String(error) },
        made: [],
      };
    }
  }

  /** @param {Omit<import("../state/origin.js").Origin, "layers">} origin @param {unknown[]} layers */
  async #open(origin, layers) {
    const { opening, drawing, messages } = this.#host;
    const summary = await opening.open({ ...origin, layers });
    messages.settle("offer");
    await drawing.drawn();
    return summary;
  }

  /** Statistics of every metric. @returns {Promise<Record<string, Numbers>>} */
  async #measure() {
    /** @type {Record<string, Numbers>} */
    const quality = {};
    for (const { id } of this.#host.tables.metrics) {
      const statistics = await this.#host.client.call("quality", [id]);
      quality[id] = Object.fromEntries(this.#host.tables.statistics.map((name) => [name, statistics[name]]));
    }
    return quality;
  }
}

/** @param {string} name @param {Blob} blob @returns {Promise<Made>} */
async function madeOf(name, blob) {
  return { name, bytes: new Uint8Array(await blob.arrayBuffer()) };
}
