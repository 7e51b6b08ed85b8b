import { CoreError, Superseded } from "../core/client.js";
import { stemOf } from "../files/names.js";
import { writeZip } from "../files/zip.js";
import { meshesIn, originIn, settingsBeside } from "./archive.js";
import { columnsOf, comparisonOf } from "./compared.js";

/**
 * A zip of meshes in, a zip of pictures, histograms and measurements out (SPEC B1). Each is drawn under the defaults with
 * the common status laid over them, and over that the one beside the mesh (`name.json` or `name.txt`), of which nothing
 * stays for the next. A mesh that fails is told in the table; the rest goes on. While the page compares, each is compared
 * with the second mesh, or with the reference surface.
 *
 * @typedef {import("../files/zip.js").Entry} Entry
 * @typedef {{ width?: number, height?: number, figures?: boolean, status?: unknown, signal?: AbortSignal,
 *   report?: (done: number, of: number, name: string, failed: number) => void }} Options
 * @typedef {{ width?: number, height?: number }} Size
 * @typedef {Record<string, string | number>} Row  a line of the table
 * @typedef {Record<string, number | null>} Numbers  statistics by name, null where they are none
 * @typedef {{ name: string, problem: string, picture?: string, unit?: string, vertices?: number, cells?: number, boundary_faces?: number,
 *   quality?: Record<string, Numbers>, comparison?: import("./compared.js").Comparison }} Measured  what is told of a mesh: of one that failed, name and problem
 * @typedef {{ name: string, bytes: Uint8Array<ArrayBuffer> }} Made  a file
 * @typedef {import("../state/answers.js").Summary} Summary
 * @typedef {{ id: string, name: string }} Beside  what the core has at hand to compare a mesh with, and what the table calls it
 * @typedef {{ layers: () => Promise<unknown[]>, size: Size, figures: boolean, beside?: Beside }} How  layers: documents that make up
 *   a mesh's settings, laid over each other
 *
 * @typedef {object} Side  one of two meshes, or the only one
 * @property {Pick<import("../core/client.js").CoreClient, "call">} client
 * @property {{ identified: Promise<void> }} opening
 * @property {{ measured: () => Promise<void>, filled: Promise<void> }} measures
 * @property {{ drawn: () => Promise<void> }} drawing
 *
 * @typedef {object} Comparing  what the mesh is compared with
 * @property {boolean} stands whether it is compared with something
 * @property {readonly Side[]} sides
 * @property {Side | null} second null where there is none, or a reference surface
 * @property {Promise<void>} matched when both know of each other
 * @property {{ measure: () => Promise<import("../state/facts.js").Apart | null> }} distances
 * @property {(metric: string) => Promise<import("../state/answers.js").Changes | null>} changes
 * @property {(id: string) => Promise<void>} openOffered
 * @property {() => void} close
 *
 * @typedef {object} Host  what a batch needs of the application
 * @property {Pick<import("../state/store.js").StatusStore, "status" | "touched">} store
 * @property {Pick<import("../state/tables.js").Tables, "formats" | "metrics" | "statistics">} tables
 * @property {Pick<import("../state/facts.js").Facts, "get">} facts
 * @property {Pick<import("../core/client.js").CoreClient, "call">} client
 * @property {{ open: (origin: import("../state/origin.js").Origin) => Promise<Summary>, mark: () => () => Promise<void> }} opening mark: what
 *   comes back to what is open
 * @property {{ replaceBy: (layers: readonly unknown[]) => Promise<void> }} documents
 * @property {{ settle: (topic: string) => void }} messages
 * @property {Comparing} comparing
 * @property {{ picture: (size: Size) => Promise<Blob>, figure: (size: Size | null) => Promise<Blob>, histogram: (format: "png" | "svg") => Promise<Blob | null> }} saving
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
export function rowOf({ quality = {}, comparison, ...facts }) {
  const statistics = Object.entries(quality).flatMap(([id, numbers]) =>
    Object.entries(numbers).map(([name, value]) => [`${id}_${name}`, value ?? ""]),
  );
  return { ...facts, ...Object.fromEntries(statistics), ...(comparison ? columnsOf(comparison) : {}) };
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
   * The mesh that was open is open again afterwards, under the settings that it had, and is compared with what it was.
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
      await this.#host.comparing.matched;
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
   * @param {How} how
   * @returns {Promise<{ measured: Measured, made: Made[] }>}
   */
  async portray(name, stem, origin, { layers, size, figures, beside }) {
    const { comparing, store } = this.#host;
    try {
      const { vertices, cells, boundary_faces } = await this.#open(origin, await layers(), beside);
      if (figures) await this.#measured(); // of which the legend tells
      const picture = `${stem}.png`;
      const made = [await madeOf(picture, await this.#picture(size, figures))];
      await this.#measured();
      made.push(...(await this.#histograms(stem)));
      const quality = await this.#measure();
      const { unit } = store.status;
      const named = unit === "none" ? {} : { unit };
      const counts = { vertices, cells, boundary_faces };
      const told = comparing.stands
        ? {
            comparison: await comparisonOf(
              this.#host,
              beside?.name ?? store.status.compare.other.name,
              quality,
            ),
          }
        : {};
      return { measured: { name, problem: "", picture, ...named, ...counts, quality, ...told }, made };
    } catch (error) {
      if (error instanceof Superseded)
        throw new Error("the batch was stopped: another mesh was opened", { cause: error });
      if (error instanceof CoreError && error.kind === "WorkerError") throw error;
      return {
        measured: { name, problem: error instanceof Error ? error.message : String(error) },
        made: [],
      };
    } finally {
      if (beside) comparing.close();
    }
  }

  /**
   * Settings of a mesh that is compared come when both know of each other: they may name what comes out of that.
   *
   * @param {Omit<import("../state/origin.js").Origin, "layers">} origin @param {unknown[]} layers @param {Beside} [beside]
   */
  async #open(origin, layers, beside) {
    const { opening, messages, comparing, documents } = this.#host;
    const compared = comparing.stands || beside !== undefined;
    const summary = await opening.open({ ...origin, layers: compared ? [] : layers });
    messages.settle("offer");
    if (compared) {
      if (beside) await comparing.openOffered(beside.id);
      await comparing.matched;
      const film = comparing.second ? [] : [{ compare: { reference: { shown: true } } }];
      await documents.replaceBy([...film, ...layers]);
    }
    for (const { opening, measures, drawing } of comparing.sides) {
      await opening.identified; // which the pictures carry
      await measures.filled; // irregular edges wait for that
      await drawing.drawn();
    }
    return summary;
  }

  /** Statistics and histogram are those of what is open. */
  async #measured() {
    await Promise.all(this.#host.comparing.sides.map(({ measures }) => measures.measured()));
  }

  /** Of two meshes the picture shows both, as a figure does. @param {Size} size @param {boolean} figures */
  #picture(size, figures) {
    const { saving, comparing } = this.#host;
    if (figures) return saving.figure(size.width || size.height ? size : null);
    return comparing.second ? saving.figure(size) : saving.picture(size);
  }

  /** @param {string} stem @returns {Promise<Made[]>} */
  async #histograms(stem) {
    const { quantity = "" } = this.#host.facts.get("histogram") ?? {};
    const made = [];
    for (const format of /** @type {const} */ (["png", "svg"])) {
      const histogram = await this.#host.saving.histogram(format);
      if (histogram)
        made.push(await madeOf(`${stem}-${quantity.replace(/[^\w-]+/g, "-")}.${format}`, histogram));
    }
    return made;
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
