import { meshAddress } from "./address.js";
import { nameOf } from "./opening.js";
import { Comparing } from "./comparing.js";
import { Documents } from "./documents.js";
import { Figures } from "./figures.js";
import { Files, foundOf } from "./files.js";
import { Keeping } from "./keeping.js";
import { LastFiles } from "./last_files.js";
import { Leaving } from "./leaving.js";
import { NewVersion } from "./new_version.js";
import { Offered } from "./offered.js";
import { Portraits } from "./portraits.js";
import { rememberPreferences } from "./preferences.js";
import { Shared } from "./shared.js";
import { Side } from "./side.js";
import { SinglePage } from "./single_page.js";
import { Reports } from "./reports.js";
import { Saving } from "./saving.js";
import { StartWatch } from "./start_watch.js";
import { Steps } from "./steps.js";
import { Turntable } from "./turntable.js";
import { Superseded } from "../core/client.js";
import { Batch } from "../batch/batch.js";
import { hasAttribute, openingSettings, ownView } from "../state/opening_view.js";
import { counted } from "../state/numbers.js";
import { comparedOf } from "../state/tables.js";

/**
 * The application: holds status, facts, core and scene together. Panels, keys and scripts call its actions; settings
 * go through the store.
 *
 *     const app = new App({ store, facts, client, scene, tables, canvas, host });
 *     app.start();
 *     await app.openFiles([file]);
 *
 * @typedef {import("../state/facts.js").MeshSummary} MeshSummary
 * @typedef {import("../widgets/bind.js").Actions} Actions
 *
 * @implements {Actions}
 */
export class App extends Side {
  /** The catalogue, once it is there; null if there is none. @type {Promise<import("../catalogue/catalogue.js").Catalogue | null>} */
  catalogue = Promise.resolve(null);

  /** @param {import("./side.js").Parts} parts @param {(() => import("./comparing.js").Second) | null} [makeSecond] what a second mesh is shown by */
  constructor(parts, makeSecond = null) {
    super(parts);
    const { host } = parts;
    /** @type {Portraits} */
    this.portraits = new Portraits(this);
    this.documents = new Documents(this);
    this.saving = new Saving(this);
    this.files = new Files(this);
    this.figures = new Figures(this);
    this.leaving = new Leaving(this);
    this.singlePage = new SinglePage(this);
    this.turntable = new Turntable(this);
    this.reports = new Reports(this);
    this.steps = new Steps(this);
    this.lastFiles = new LastFiles(this);
    this.batch = new Batch(this);
    this.keeping = new Keeping(this);
    this.newVersion = new NewVersion(this);
    this.comparing = new Comparing(this, makeSecond);
    this.offered = host.offers && new Offered(this, host.offers);
  }

  /**
   * Wait for the core and the catalogue, and listen to what can go wrong.
   *
   * @param {{ addressed?: boolean }} [options] whether a mesh is about to be opened, whose preview has the GPU for itself
   */
  start({ addressed = false } = {}) {
    const { client, scene, facts, store, messages } = this;
    const began = performance.now();
    const starting = this.progress.begin(loadingInWords(0));
    let files = 0;
    client.addEventListener("loading", () => starting.report(null, loadingInWords(++files)));
    const watch = new StartWatch(client, messages);
    client.ready
      .then(
        () => this.note({ boot: performance.now() - began }),
        (/** @type {Error} */ error) => {
          const action = { name: "try again", press: () => location.reload() };
          messages.settle("open"); // which says the same
          messages.say("error", `The measuring engine could not be started: ${error.message}`, {
            topic: "core",
            action,
          });
        },
      )
      .finally(() => {
        starting.end();
        watch.end();
        if (this.host.keeps) void this.newVersion.start();
      });
    this.followCore();
    scene.on("camera", (camera) => store.set({ camera }, { undo: "camera" }));
    scene.on("contextlost", () =>
      messages.say(
        "warning",
        "The browser took the graphics away; the picture comes back when it returns them",
        { topic: "context" },
      ),
    );
    scene.on("contextrestored", () => messages.settle("context"));
    this.catalogue = this.#fetchCatalogue();
    rememberPreferences(facts);
    this.steps.start();
    if (this.host.keeps) void this.lastFiles.start();
    this.offered?.start();
    if (this.host.port) new Shared(this, this.host.port).start();
    if (!addressed) void scene.prepare();
  }

  async #fetchCatalogue() {
    try {
      const catalogue = await this.ahead.catalogue;
      this.facts.set({ catalogue });
      return catalogue;
    } catch (error) {
      this.messages.error(error, { topic: "catalogue" });
      return null;
    }
  }

  /**
   * The settings that a mesh opens under are its own, or what was set by hand for the one before.
   *
   * @param {import("./side.js").Origin} origin @param {MeshSummary} summary
   */
  adopt(origin, summary) {
    const { facts, store } = this;
    const before = facts.get("summary");
    const { status } = store;
    const alike = before?.cells === summary.cells;
    const changed = new Set(store.touched);
    const touched = new Set([...changed, ...(this.comparing.stands ? ["compare"] : [])]); // with what it is compared stays
    const { settings, kept } = openingSettings(
      ownView(store.defaults, summary.view, origin.entry?.mesh.view),
      {
        status,
        touched,
        keeping: before ? facts.get("keeping") : "changed",
        renewed: origin.renewed === true,
        alike,
        same: origin.renewed === true || (alike && status.mesh.name === nameOf(origin, summary)),
        // Quantities of a comparison wait until both meshes know of each other.
        has: (quantity, components) =>
          comparedOf(this.tables, quantity) !== undefined || hasAttribute(summary, quantity, components),
      },
    );
    store.set(settings, { undo: false });
    store.forget();
    if (origin.renewed) store.touch(changed);
    return kept && before !== null && !origin.renewed;
  }

  /** @param {Pick<import("./side.js").Origin, "layers" | "status">} origin */
  async dress({ layers, status }) {
    if (layers) await this.documents.replaceBy(layers);
    if (status) await this.documents.apply(status);
  }

  /**
   * Open dropped or chosen files; see `Files`.
   *
   * @param {readonly (File | import("./files.js").Found)[]} files @returns {Promise<MeshSummary | null>} the mesh's summary, or null if there was none
   */
  async openFiles(files) {
    this.steps.leave();
    const found = foundOf(files);
    const summary = await this.files.open(found);
    if (!summary) return null;
    this.steps.add(null, () => this.files.open(found));
    if (this.host.keeps) void this.lastFiles.keep(found);
    return summary;
  }

  /** Offer pictures and measurements of many meshes. @param {readonly (File | import("./files.js").Found)[]} files */
  offerBatch(files) {
    return this.files.offerBatch(foundOf(files));
  }

  /** @param {string} address @param {unknown} [status] */
  async openUrl(address, status) {
    this.steps.leave();
    const whole = this.meshAddress(address);
    const summary = await this.opening.open({ ...this.fetching.from(whole), status });
    this.steps.add(whole, () => this.opening.open(this.fetching.from(whole)));
    return summary;
  }

  /** A whole address out of what a link or a script gives. @param {string} address @throws {Error} which was shown, too */
  meshAddress(address) {
    try {
      return meshAddress(address, document.baseURI);
    } catch (error) {
      this.messages.error(error, { topic: "open" });
      throw error;
    }
  }

  /** Choose a source of the catalogue, whose meshes are then offered; its only one is opened. @param {string} slug */
  async chooseSource(slug) {
    const source = this.facts.get("catalogue")?.source(slug) ?? null;
    this.facts.set({ source });
    if (source?.meshes.length === 1) await this.chooseEntry(slug, source.meshes[0].slug);
  }

  /**
   * Open a mesh that was chosen: what goes wrong has been said in a message, and the choice is again that of the mesh on
   * the screen.
   *
   * @param {string} source @param {string} mesh @param {unknown} [status]
   */
  async chooseEntry(source, mesh, status) {
    try {
      await this.openEntry(source, mesh, status);
    } catch (error) {
      if (!(error instanceof Superseded)) this.facts.set({ source: this.facts.get("entry")?.source ?? null });
    }
  }

  /** Open a mesh of the catalogue. @param {string} source @param {string} mesh @param {unknown} [status] */
  async openEntry(source, mesh, status) {
    if (!mesh) return null;
    this.steps.leave();
    const catalogue = await this.catalogue;
    const entry = catalogue?.entry(source, mesh);
    if (!entry) {
      const error = new Error(`the catalogue has no mesh ${source}/${mesh}`);
      this.messages.error(error, { topic: "open" });
      throw error;
    }
    const url = this.meshAddress(entry.mesh.url);
    const origin = { ...this.fetching.from(url, entry.mesh), entry };
    const summary = await this.opening.open({ ...origin, status });
    this.steps.add(`${source}/${mesh}`, () => this.opening.open(origin));
    return summary;
  }

  /** Open the mesh before or after this one in its source. @param {number} step */
  openBeside(step) {
    const entry = this.facts.get("entry");
    const next = entry && this.facts.get("catalogue")?.beside(entry, step);
    if (next) void this.chooseEntry(next.source.slug, next.mesh.slug);
  }

  saveWorst() {
    return this.saving.saveWorst();
  }

  saveValues() {
    return this.saving.saveValues();
  }

  /** @param {import("../widgets/bind.js").ChartFormat} format */
  saveHistogram(format) {
    return this.saving.saveHistogram(format);
  }
}

/** @param {number} files that have come */
function loadingInWords(files) {
  return `loading the measuring engine${files ? `, ${counted(files, "file")} so far` : ""}`;
}
