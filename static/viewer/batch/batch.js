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
 * @typedef {Record<string, string | number>} Row
 * @typedef {import("../state/answers.js").Summary} Summary
 *
 * @typedef {object} Host  what a batch needs of the application
 * @property {Pick<import("../state/store.js").StatusStore, "status" | "touched">} store
 * @property {Pick<import("../state/tables.js").Tables, "formats" | "metrics" | "statistics">} tables
 * @property {Pick<import("../state/facts.js").Facts, "get">} facts
 * @property {Pick<import("../core/client.js").CoreClient, "call">} client
 * @property {{ open: (origin: import("./archive.js").EntryOrigin & { layers: unknown[] }) => Promise<Summary>, mark: () => () => Promise<void> }} opening mark: what
 *   comes back to what is open
 * @property {{ replaceBy: (layers: readonly unknown[]) => Promise<void> }} documents
 * @property {{ drawn: () => Promise<void> }} drawing
 * @property {{ measured: () => Promise<void> }} measures
 * @property {{ settle: (topic: string) => void }} messages
 * @property {{ picture: (size: Size) => Promise<Blob>, figure: (size: Size) => Promise<Blob>, histogram: (format: "png") => Promise<Blob | null> }} saving
 */

/** The stem, or with a number added if a mesh of the same stem has it: both have pictures. @param {string} stem @param {Set<string>} names taken ones, in lower case */
function freeName(stem, names) {
  let free = stem;
  for (let number = 2; names.has(free.toLowerCase()); number++) free = `${stem}-${number}`;
  names.add(free.toLowerCase());
  return free;
}

/** @param {readonly Row[]} rows */
function failedOf(rows) {
  return rows
    .filter(({ problem }) => problem)
    .map(({ name, problem }) => ({ name: String(name), problem: String(problem) }));
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
   * @returns {Promise<{ zip: Blob, failed: { name: string, problem: string }[] }>} a zip: NAME.png and NAME-METRIC.png for each
   *   mesh, measurements.csv; and the meshes that failed
   */
  async run(entries, { width, height, figures = false, status, signal, report } = {}) {
    const meshes = await meshesIn(entries, this.#host.tables.formats);
    if (!meshes.length) throw new Error("there is no mesh among them");
    const comeBack = this.#host.opening.mark();
    const common = status ?? this.#present();
    const files = [];
    const rows = [];
    const names = new Set();
    try {
      for (const [index, whole] of meshes.entries()) {
        signal?.throwIfAborted();
        report?.(index, meshes.length, whole.mesh.name, failedOf(rows).length);
        const { row, made } = await this.#one(whole, entries, common, names, {
          size: { width, height },
          figures,
        });
        rows.push(row);
        files.push(...made);
      }
    } finally {
      await comeBack().catch(() => {}); // which was told
    }
    const failed = failedOf(rows);
    report?.(meshes.length, meshes.length, "", failed.length);
    files.push({ name: "measurements.csv", bytes: new TextEncoder().encode(toCsv(rows)) });
    return { zip: writeZip(files), failed };
  }

  /** The present settings; each mesh is seen in its own view where that was not changed. */
  #present() {
    const { status, touched } = this.#host.store;
    const { camera, filters, ...others } = status;
    return touched.has("camera") || touched.has("filters") ? status : others;
  }

  /** @param {import("./archive.js").WholeEntry} whole @param {Entry[]} entries @param {unknown} common @param {Set<string>} names taken ones @param {{ size: { width?: number, height?: number }, figures: boolean }} how */
  async #one(whole, entries, common, names, { size, figures }) {
    const { mesh } = whole;
    const stem = freeName(stemOf(mesh.name), names);
    try {
      const layers = [common, ...(await settingsBeside(mesh, entries))];
      const summary = await this.#open(whole, layers);
      if (figures) await this.#host.measures.measured(); // of which the legend tells
      const { saving } = this.#host;
      const picture = await (figures ? saving.figure(size) : saving.picture(size));
      const made = [{ name: `${stem}.png`, bytes: await bytesOf(picture) }];
      await this.#host.measures.measured();
      const histogram = await this.#host.saving.histogram("png");
      const { quantity = "" } = this.#host.facts.get("histogram") ?? {};
      if (histogram)
        made.push({
          name: `${stem}-${quantity.replace(/[^\w-]+/g, "-")}.png`,
          bytes: await bytesOf(histogram),
        });
      return { row: { ...rowOf(mesh.name, summary, `${stem}.png`), ...(await this.#measure()) }, made };
    } catch (error) {
      if (error instanceof Superseded)
        throw new Error("the batch was stopped: another mesh was opened", { cause: error });
      if (error instanceof CoreError && error.kind === "WorkerError") throw error;
      return {
        row: { name: mesh.name, problem: error instanceof Error ? error.message : String(error) },
        made: [],
      };
    }
  }

  /** @param {import("./archive.js").WholeEntry} whole @param {unknown[]} layers */
  async #open(whole, layers) {
    const { opening, drawing, messages } = this.#host;
    const summary = await opening.open({ ...originIn(whole), layers });
    messages.settle("offer");
    await drawing.drawn();
    return summary;
  }

  /** Statistics of every metric, a column for each. @returns {Promise<Row>} */
  async #measure() {
    /** @type {Row} */
    const row = {};
    for (const { id } of this.#host.tables.metrics) {
      const statistics = await this.#host.client.call("quality", [id]);
      for (const name of this.#host.tables.statistics) row[`${id}_${name}`] = statistics[name] ?? "";
    }
    return row;
  }
}

/** @param {string} name @param {Summary} summary @param {string} picture @returns {Row} */
function rowOf(name, { vertices, cells, boundary_faces }, picture) {
  return { name, problem: "", picture, vertices, cells, boundary_faces };
}

/** @param {Blob} blob */
async function bytesOf(blob) {
  return new Uint8Array(await blob.arrayBuffer());
}
