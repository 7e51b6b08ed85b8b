import { rowOf } from "../batch/batch.js";
import { readZip } from "../files/zip.js";

/**
 * `window.hexalab`: the viewer for scripts and tests, and, by `parent.js`, for pages that embed it (SPEC A3).
 *
 * @typedef {Omit<import("../state/facts.js").MeshSummary, "outline"> & Partial<import("../state/answers.js").Description>
 *   & { shown: { cells: number, faces: number } | null }} Known
 * @typedef {import("../state/status.js").Status} Status
 */
export class HexaLab {
  #app;

  /** Resolves when the core runs. @type {Promise<void>} */
  ready;

  /** Of the program. @type {string} */
  version;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
    this.version = app.tables.version;
    this.ready = app.client.ready.then(() => undefined);
    this.ready.catch(() => {}); // said in a message, whoever waits for it
  }

  /**
   * Open a mesh. The picture stands before the promise resolves: that waits for the slow part of the summary too.
   *
   * @param {File | Blob | string} fileOrUrl a file, an address, or "source/mesh" of the catalogue
   * @returns {Promise<Known | null>} what is known of the mesh: name, vertices, cells, kinds, boundary_faces, findings, ...; null if
   *   what was opened holds no mesh, and none was open before
   */
  async open(fileOrUrl) {
    await this.#opened(fileOrUrl);
    await this.#app.measures.filled;
    return this.summary();
  }

  /** @param {File | Blob | string} fileOrUrl */
  async #opened(fileOrUrl) {
    if (fileOrUrl instanceof Blob) {
      const file = fileOrUrl instanceof File ? fileOrUrl : new File([fileOrUrl], "mesh");
      return this.#app.openFiles([file]);
    }
    const catalogue = await this.#app.catalogue;
    const [source, mesh] = fileOrUrl.split("/");
    if (mesh && catalogue?.entry(source, mesh)) return this.#app.openEntry(source, mesh);
    return this.#app.openUrl(fileOrUrl);
  }

  /** Meshes that can be opened by `openOffered`: the files of `hexalab view`, a notebook's mesh. @returns {readonly { id: string, name: string }[]} */
  offers() {
    return this.#app.facts.get("offers");
  }

  /** Open a mesh that is at hand; as `open`. @param {string} id @returns {Promise<Known | null>} */
  async openOffered(id) {
    if (!this.#app.offered) throw new Error("nothing is at hand here");
    await this.#app.offered.open(id);
    await this.#app.measures.filled;
    return this.summary();
  }

  /** Summary of the open mesh, with what its description tells by now, or null. @returns {Known | null} */
  summary() {
    const { facts } = this.#app;
    const summary = facts.get("summary");
    if (!summary) return null;
    const { outline: _, ...told } = summary;
    return { ...told, ...facts.get("description"), shown: facts.get("shown") };
  }

  /** Bytes of memory that the core holds, null while that is not known: it grows with the largest mesh, and never shrinks. @returns {number | null} */
  memory() {
    return this.#app.client.memory;
  }

  /** The same of each core, the second mesh's last. @returns {(number | null)[]} */
  memories() {
    return this.#app.comparing.memory;
  }

  /** The status document: a copy. @returns {Status} */
  getStatus() {
    return structuredClone(this.#app.store.status);
  }

  /**
   * Apply a whole or partial status document.
   *
   * @param {unknown} partial of any version, or the original's
   * @returns {Promise<import("../state/answers.js").Rejection[]>} what was wrong in it, once the rest is applied and drawn
   */
  async setStatus(partial) {
    const rejections = await this.#app.documents.apply(partial);
    await this.#app.drawing.drawn();
    return rejections;
  }

  /** Put all settings back to those that the open mesh has of its own. @returns {Promise<void>} when that is drawn */
  async reset() {
    await this.#app.views.resetAll();
    await this.#app.drawing.drawn();
  }

  /** Resolves when the open mesh is identified by its SHA-256, and a second one by its own; which then stand in the status. @returns {Promise<void>} */
  async identified() {
    await Promise.all(this.#app.comparing.sides.map(({ opening }) => opening.identified));
  }

  /** Draw nothing on the page until `settled` is called: for programs that take pictures, which are drawn apart. */
  rest() {
    for (const { scene } of this.#app.comparing.sides) scene.rest();
  }

  /** Resolves when the lighting has converged. @returns {Promise<void>} */
  async settled() {
    for (const { drawing, scene } of this.#app.comparing.sides) {
      await drawing.drawn();
      await scene.settled();
    }
  }

  /**
   * @param {{ width?: number, height?: number, transparent?: boolean }} [options] pixels; as large as the canvas without
   * @returns {Promise<Blob>} a PNG that carries the status
   */
  screenshot(options = {}) {
    return this.#app.saving.picture(options);
  }

  /**
   * The figure that the status asks for (its section `figure`): pictures with legend, scale bar, axes, caption.
   *
   * @param {import("./figures.js").FigureFormat} [format] "png", which carries the status, "svg" or "pdf"
   * @param {{ width?: number, height?: number }} [size] pixels, instead of what the status asks for
   * @param {"both" | "first" | "second"} [which] of two meshes that are compared
   * @returns {Promise<Blob>}
   */
  figure(format = "png", size = undefined, which = "both") {
    return this.#app.figures.file(format, size, which);
  }

  /**
   * The shown cells as a mesh (SPEC A8).
   *
   * @param {string} format "vtu", "vtk", "mesh", ...: what meshes are written in
   * @param {{ metrics?: string[], attributes?: string[] | null, structure?: boolean }} [options] metrics that become attributes of the
   *   cells; attributes of the file that come along, all by default; whether sheets, chords and block of each cell do
   * @returns {Promise<{ file: Blob, ending: string, notes: readonly string[] }>} notes: what the format has no place for
   */
  cells(format, options = {}) {
    return this.#app.leaving.cells(format, options);
  }

  /**
   * The shown surface (SPEC A8).
   *
   * @param {string} format "glb", "ply", "obj" or "stl"
   * @param {{ light?: boolean, reference?: string }} [options] light: whether it is in the colours, by default where it comes from
   *   all around
   * @returns {Promise<{ file: Blob, ending: string, notes: readonly string[] }>}
   */
  surface(format, options = {}) {
    return this.#app.leaving.surface(format, options);
  }

  /** The mesh in a page of one file (SPEC A7). @param {import("../state/leaving.js").PageWanted} [options] @returns {Promise<Blob>} */
  page(options = {}) {
    return this.#app.singlePage.file(options);
  }

  /** Pictures around the mesh (SPEC A8). @param {import("../state/leaving.js").Turn} [options] @returns {Promise<Blob>} a zip of pictures, or a video */
  turntable(options = {}) {
    return this.#app.turntable.file(options);
  }

  /**
   * The report of the open mesh: what it is, and whether it passes.
   *
   * @param {string} [form] "html" with pictures, "md", "json" or "xml" (JUnit)
   * @param {import("../state/leaving.js").ReportWanted} [wanted]
   * @returns {Promise<{ file: Blob, ending: string, passed: boolean, notes: readonly string[] }>} notes: what it lacks
   */
  report(form = "html", wanted = {}) {
    return this.#app.reports.file(form, wanted);
  }

  /** The pictures of a report: what each shows, and a PNG. @returns {Promise<{ title: string, alt: string, picture: Blob }[]>} */
  reportPictures() {
    return this.#app.reports.pictures();
  }

  /** Statistics of a metric or an attribute over the mesh. @param {string} quantity id @returns {Promise<import("../state/answers.js").Statistics>} */
  quality(quantity) {
    return this.#app.client.call("quality", [quantity]);
  }

  /** The file's groups and its elements of lower dimension (SPEC R12, R13). @returns {Promise<Pick<import("../state/answers.js").Description, "groups" | "features">>} */
  async groups() {
    const { groups, features } = await this.#app.client.call("describe", ["groups"]);
    if (!groups || !features) throw new Error("the core told no groups");
    return { groups, features };
  }

  /** Size and quality of each group of cells. @returns {Promise<import("../state/answers.js").GroupMeasures[]>} */
  groupStatistics() {
    return this.#app.client.call("group_table", []);
  }

  /** Where the groups of an origin meet, such as "material". @param {string} origin @returns {Promise<import("../state/answers.js").Interface[]>} */
  interfaces(origin) {
    return this.#app.client.call("interfaces", [origin]);
  }

  /**
   * The structure of the open mesh (SPEC T), as `hexalab structure --json` tells it.
   *
   * @returns {Promise<import("../state/answers.js").StructureFacts>}
   */
  async structure() {
    await this.#app.structured.trace();
    return this.#app.client.call("structure_facts", [true]);
  }

  /**
   * A table of the structure: "arcs", "nodes", "sheets", "chords" or "blocks".
   *
   * @param {string} table @param {"whole" | "interior"} [variant] which arcs or blocks: of all irregular edges, or of those inside alone
   * @returns {Promise<import("../state/answers.js").StructureTable>}
   */
  structureTable(table, variant = "whole") {
    return this.#app.client.call("structure_table", [table, variant]);
  }

  /** Show a cell or a vertex, and what lies around it, by the number of its file (SPEC R11). @param {"cell" | "vertex"} kind @param {number} number */
  async goTo(kind, number) {
    await this.#app.goTo(kind, number);
    await this.#app.drawing.drawn();
  }

  /**
   * Draw and measure every mesh of an archive (SPEC B1), and compare each with what the open mesh is compared with.
   *
   * @param {Blob} archive a zip of meshes; `name.json` beside a mesh is its own status
   * @param {unknown} [status] whole or partial, for all others; the present one without
   * @param {{ width?: number, height?: number, figures?: boolean, report?: (done: number, of: number, name: string, failed: number) => void }} [options]
   * @returns {Promise<Blob>} a zip of pictures, histograms, measurements.csv and measurements.json
   */
  async batch(archive, status, options = {}) {
    const { zip } = await this.#app.batch.run(readZip(await archive.arrayBuffer()), { ...options, status });
    return zip;
  }

  /**
   * Draw and measure a mesh that is at hand, as `batch` does each of an archive.
   *
   * @param {string} id
   * @param {{ name: string, stem: string, layers: unknown[], width?: number, height?: number, figures?: boolean, beside?: import("../batch/batch.js").Beside }} how
   *   what it and its files are called, the documents that make up its settings, and what it is compared with meanwhile
   * @returns {Promise<{ measured: import("../batch/batch.js").Measured, row: import("../batch/batch.js").Row, made: import("../batch/batch.js").Made[] }>}
   */
  async portray(id, { name, stem, layers, width, height, figures = false, beside }) {
    const how = { layers: async () => layers, size: { width, height }, figures, beside };
    const { measured, made } = await this.#app.batch.portray(name, stem, { name, offered: id }, how);
    return { measured, row: rowOf(measured), made };
  }

  /**
   * Compare the open mesh with another, or with a reference surface (SPEC S6, S7).
   *
   * @param {File | Blob | string} fileOrUrl a file, an address, or "source/mesh" of the catalogue
   * @returns {Promise<import("../state/answers.js").Compared | null>} what it is compared with; null if the page lost it again
   */
  async compare(fileOrUrl) {
    const { comparing } = this.#app;
    if (fileOrUrl instanceof Blob) {
      const file = fileOrUrl instanceof File ? fileOrUrl : new File([fileOrUrl], "mesh");
      await comparing.openFiles([file]);
    } else {
      const catalogue = await this.#app.catalogue;
      const [source, mesh] = fileOrUrl.split("/");
      if (mesh && catalogue?.entry(source, mesh)) await comparing.openEntry(source, mesh);
      else await comparing.openUrl(fileOrUrl);
    }
    return this.#compared();
  }

  /** Compare with what is at hand; see `offers`. @param {string} id @returns {Promise<import("../state/answers.js").Compared | null>} */
  async compareOffered(id) {
    await this.#app.comparing.openOffered(id);
    return this.#compared();
  }

  /** When both know of each other, and are drawn with all that is drawn of them. */
  async #compared() {
    const { comparing, facts } = this.#app;
    await comparing.matched;
    for (const { drawing, measures } of comparing.sides) {
      await measures.filled;
      await drawing.drawn();
    }
    return facts.get("comparison");
  }

  /** What the open mesh is compared with, and what is known of a second one; null while there is none. */
  comparison() {
    const { facts } = this.#app;
    const told = facts.get("comparison");
    const second = facts.get("second")?.get("summary") ?? null;
    return told && { ...told, second: second && { ...second, outline: undefined } };
  }

  /** How far the two surfaces are apart, both ways; measured when it is asked for first. @returns {Promise<import("../state/facts.js").Apart | null>} */
  distances() {
    return this.#app.comparing.distances.measure();
  }

  /** At how many cells a metric got worse; null where the cells are others. @param {string} metric @returns {Promise<import("../state/answers.js").Changes | null>} */
  changes(metric) {
    return this.#app.comparing.changes(metric);
  }

  /** Each of two meshes takes the place of the other. */
  async swap() {
    await this.#app.comparing.swap();
    await this.#app.comparing.matched;
  }

  /** The second mesh, or the reference surface, goes. */
  endComparison() {
    this.#app.comparing.close();
  }

  /** What is drawn at the moment: faces, triangles, edges, cells, and how many frames so far. @returns {{ faces: number, triangles: number, edges: number, cells: number, frames: number }} */
  drawn() {
    return { ...this.#app.scene.drawn(), frames: this.#app.scene.frames };
  }

  /** Replace the core's worker, as after a crash; the mesh is opened again. */
  restart() {
    this.#app.client.restart();
  }

  /**
   * Milliseconds of what was done last: boot, and of it interpreter, numpy, core; preview, from the page's address to a
   * catalogue mesh's first picture; read, topology, summary, first_picture of a mesh; describe, quality; filters,
   * surface, silhouette, irregular, arrows, colour, update in the core, slice with its way there; upload, frame, lighting.
   *
   * @returns {Record<string, number>}
   */
  timings() {
    return { ...this.#app.facts.get("timings"), ...this.#app.scene.timings };
  }
}
