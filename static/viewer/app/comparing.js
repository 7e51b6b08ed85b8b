import { CoreError, Superseded } from "../core/client.js";
import { tableCsv, withoutComparison } from "../state/compared.js";
import { Distances } from "./distances.js";
import { saveFile } from "./saving.js";
import { SeenTogether } from "./seen_together.js";
import { match } from "./matching.js";
import { fromFile } from "./opening.js";

/**
 * A second mesh beside the page's, under the one status, or a reference surface over it (SPEC S6, S7).
 *
 * @typedef {import("./side.js").Side} Side
 * @typedef {import("../state/second_store.js").SecondStore} SecondStore
 * @typedef {import("../state/origin.js").Origin} Origin
 * @typedef {Side & { store: SecondStore, close: () => void }} Second
 * @typedef {() => Promise<import("../state/answers.js").Compared>} TakeSurface
 */

/** What is read of a file that is no mesh: a surface to measure against. */
const NO_MESH = ["NoCellsError", "MeshReadError"];

export class Comparing {
  #app;
  #make;
  #together;
  /** @type {Second | null} */
  #second = null;
  /** Takes the reference surface, and takes it again when the core was restarted. @type {TakeSurface | null} */
  #surface = null;
  /** What the core has the reference surface at hand by. @type {string | null} */
  #offered = null;
  #turn = 0;
  /** How often a comparison was ended: a surface that is still being read then is wanted no more. */
  #ended = 0;
  /** What ends following the first mesh. @type {(() => void)[]} */
  #stops = [];
  /** Settles when both meshes know of each other. @type {Promise<void>} */
  matched = Promise.resolve();

  /** @param {import("./app.js").App} app @param {(() => Second) | null} make what a second mesh is shown by; null where there can't be one */
  constructor(app, make) {
    this.#app = app;
    this.#make = make;
    this.distances = new Distances(app, this);
    this.#together = new SeenTogether(app);
    app.taken = () => this.#unmatch();
    app.opened = () => void this.#match();
  }

  /** The second mesh; null while there is none. */
  get second() {
    return this.#second;
  }

  /** The mesh, and the second one if there is one. @returns {readonly Side[]} */
  get sides() {
    return [this.#app, ...(this.#second ? [this.#second] : [])];
  }

  /** Whether the mesh is compared with something. */
  get stands() {
    return this.#second !== null || this.#surface !== null;
  }

  /** Whether this page can show a second mesh. */
  get possible() {
    return this.#make !== null;
  }

  /**
   * Compare with a file: another mesh, or a surface.
   *
   * @param {readonly File[]} files the first of them; the others are what it includes
   */
  async openFiles(files) {
    const [file, ...parts] = files;
    if (!file) return;
    const companions = async () =>
      Object.fromEntries(await Promise.all(parts.map(async (one) => [one.name, await one.arrayBuffer()])));
    await this.#openFrom({ ...fromFile(file), ...(parts.length ? { companions } : {}) }, null);
  }

  /** Compare with a mesh, or with a surface where its name or its content says so. @param {Origin} origin @param {string | null} address */
  async #openFrom(origin, address) {
    const asSurface = async () => {
      const bytes = await /** @type {NonNullable<Origin["bytes"]>} */ (origin.bytes)(() => {});
      await this.openSurface(origin.name, new Blob([bytes]), origin.companions);
      this.#app.steps.beside(address);
    };
    const ending = /\.[^.]+$/.exec(origin.name.replace(/\.gz$/i, ""))?.[0].toLowerCase() ?? "";
    const { surfaces, formats } = this.#app.tables;
    const known = (/** @type {readonly import("../state/tables.js").FormatRow[]} */ rows) =>
      rows.some(({ extensions }) => extensions.includes(ending));
    if (known(surfaces) && !known(formats)) return asSurface();
    await this.#open(origin, address, asSurface);
  }

  /** @param {string} source @param {string} mesh of the catalogue */
  async openEntry(source, mesh) {
    const entry = (await this.#app.catalogue)?.entry(source, mesh);
    if (!entry) return this.#fail(new Error(`the catalogue has no mesh ${source}/${mesh}`));
    const url = new URL(entry.mesh.url, document.baseURI).href;
    const origin = { ...this.#app.fetching.from(url, entry.mesh), entry };
    await this.#open(origin, `${source}/${mesh}`);
  }

  /** @param {string} address of a mesh or a surface */
  async openUrl(address) {
    const whole = this.#app.meshAddress(address);
    await this.#openFrom(this.#app.fetching.from(whole), whole);
  }

  /** Compare with what the core has at hand. @param {string} id */
  async openOffered(id) {
    const offer = this.#app.facts.get("offers").find((one) => one.id === id);
    if (!offer) return this.#fail(new Error(`nothing is offered by the name of ${id}`));
    const asSurface = async () => {
      await this.#takeSurface(() => this.#app.client.call("compare_with_offered", [id]), id);
      this.#app.steps.beside(null);
    };
    await (offer.surface ? asSurface() : this.#open({ name: offer.name, offered: id }, null, asSurface));
  }

  /** Take what is compared with as its file is now, if it is the one at hand by this name. @param {string} id @returns {Promise<boolean>} whether it is */
  async renew(id) {
    const second = this.#second;
    try {
      if (second && second.facts.get("offered") === id) return Boolean(await second.opening.renew());
      if (this.#surface && this.#offered === id) {
        await this.#takeSurface(this.#surface, id);
        return true;
      }
    } catch {
      // said in a message by whoever failed: what was there stays
    }
    return false;
  }

  /** Measure against a surface, which is drawn over the mesh. @param {string} name @param {Blob} file @param {Origin["companions"]} [companions] */
  async openSurface(name, file, companions) {
    await this.#takeSurface(async () => {
      const bytes = await file.arrayBuffer();
      const parts = await companions?.();
      return this.#app.client.call("compare_with_surface", parts ? [name, bytes, parts] : [name, bytes]);
    });
  }

  /** The second mesh, or the surface, goes. */
  close() {
    const { client, facts, messages, store, steps } = this.#app;
    this.#turn++;
    this.#ended++;
    this.#surface = null;
    messages.settle("compare");
    this.#endSecond();
    facts.set({ comparison: null });
    this.distances.forget();
    steps.beside(null);
    store.set(withoutComparison(store.status, store.defaults, this.#app.tables), { undo: false });
    if (facts.get("core") === "ready" && facts.get("summary"))
      client.call("stop_comparing").then(
        () => this.#app.drawing.update(),
        () => {}, // the core has ended, and what it compared with it
      );
  }

  #endSecond() {
    for (const stop of this.#stops.splice(0)) stop();
    this.#second?.close();
    this.#second = null;
    this.#together.end();
    this.#app.facts.set({ second: null });
  }

  /** Each mesh takes the place of the other. */
  async swap() {
    const second = this.#second;
    const [a, b] = [this.#app.opening.present, second?.opening.present];
    if (!second || !a || !b) return;
    const { store, steps } = this.#app;
    const { filters, compare } = store.status;
    const { enabled, ...own } = filters.picking;
    const same = this.#app.facts.get("comparison")?.same_cells ?? false;
    steps.swap(() => this.#app.opening.open(b));
    const stays = { status: undefined, layers: undefined, renewed: true };
    try {
      await Promise.all([
        this.#app.opening.open({ ...b, ...stays }),
        second.opening.open({ ...a, ...stays }),
      ]);
    } catch {
      return; // said in a message by whoever failed
    }
    if (same) return;
    store.set(
      { filters: { picking: { enabled, ...compare.picking } }, compare: { picking: own } },
      { undo: false },
    );
  }

  /** Statistics of a quantity for both, asked for where they are not known yet. @param {string} id */
  async measure(id) {
    await Promise.all(this.sides.map((side) => side.measures.know(id)));
  }

  /** The metrics of both that were measured, as CSV. */
  saveTable() {
    const { facts, tables, saving } = this.#app;
    const second = this.#second?.facts;
    if (!second) return;
    const text = tableCsv(tables.metrics, facts.get("statistics"), second.get("statistics"));
    saveFile(new Blob([text], { type: "text/csv" }), `${saving.stem}-compared.csv`);
  }

  /** The structure of both. */
  async trace() {
    await Promise.all(this.sides.map(({ structured }) => structured.trace()));
  }

  /** Bytes of memory that each core holds; null where that is not known. */
  get memory() {
    return this.sides.map(({ client }) => client.memory);
  }

  /** At how many cells a metric got worse; null where the cells are others. @param {string} metric */
  async changes(metric) {
    if (!this.#app.facts.get("comparison")?.same_cells) return null;
    return this.#asked(() => this.#app.client.call("metric_changes", [metric]));
  }

  /** @param {Origin} origin @param {string | null} address that names it @param {() => Promise<void>} [otherwise] where it is no mesh */
  async #open(origin, address, otherwise) {
    const { facts, messages, steps } = this.#app;
    if (!facts.get("summary"))
      return this.#fail(new Error("Open a mesh first, then what it is compared with"));
    if (!this.#make) return this.#fail(new Error("A second mesh can't be shown here"));
    if (!this.#second) this.#begin(this.#make());
    const second = /** @type {Second} */ (this.#second);
    try {
      await second.opening.open(origin);
      messages.settle("compare");
      steps.beside(address);
    } catch (error) {
      if (error instanceof Superseded || this.#second !== second) return;
      if (!second.opening.present) {
        if (this.#surface) this.#endSecond();
        else this.close();
      }
      if (!otherwise || !(error instanceof CoreError) || !NO_MESH.includes(error.kind)) {
        messages.error(error, { topic: "compare" });
        throw error;
      }
      second.messages.settle("open");
      await otherwise();
    }
  }

  /** @param {Second} second */
  #begin(second) {
    const { facts, store } = this.#app;
    this.#second = second;
    second.adopt = ({ renewed }, { cells }) => {
      const before = second.facts.get("summary")?.cells ?? cells;
      const { picking } = store.defaults.compare;
      if (before !== cells && !renewed) store.set({ compare: { picking } }, { undo: false });
      return false;
    };
    second.taken = () => {
      const { shown } = store.defaults.compare.reference;
      if (this.#surface) store.set({ compare: { reference: { shown } } }, { undo: false });
      this.#surface = null;
      this.#unmatch();
    };
    second.opened = () => {
      second.facts.set({ tool: facts.get("tool") });
      void this.#match();
    };
    this.#stops = [
      facts.on("catalogue", (catalogue) => second.facts.set({ catalogue })),
      facts.on("tool", (tool) => second.facts.set({ tool })),
    ];
    this.#together.begin(second);
    facts.set({ second: second.facts });
  }

  /** One of both cores has taken another mesh: neither knows what it is compared with. */
  #unmatch() {
    this.#turn++;
    this.distances.forget();
    this.#app.facts.set({ comparison: null });
  }

  /** Have both cores know of the other's mesh. */
  #match() {
    const turn = ++this.#turn;
    this.matched = this.#matched(turn).catch((error) => {
      const wanted = turn === this.#turn && !(error instanceof Superseded);
      if (wanted) this.#app.messages.error(error, { topic: "compare" });
    });
    return this.matched;
  }

  /** @param {number} turn */
  async #matched(turn) {
    this.distances.forget();
    if (this.#surface) return this.#takeSurface(this.#surface, this.#offered);
    const [first, second] = [this.#app, this.#second];
    const there = [first, second].every(
      (side) => side?.facts.get("summary") && side.facts.get("core") === "ready",
    );
    if (!second || !there) return;
    const told = await match(first, second, () => turn === this.#turn);
    if (!told) return;
    first.facts.set({ comparison: told });
    await Promise.all([first.drawing.update(), second.drawing.update()]);
  }

  /**
   * A surface that was there already stays shown or hidden as it is.
   *
   * @param {TakeSurface} take
   * @param {string | null} [offered] what the core has it at hand by
   */
  async #takeSurface(take, offered = null) {
    const again = take === this.#surface;
    const { facts, messages, store, drawing } = this.#app;
    if (!facts.get("summary"))
      return this.#fail(new Error("Open a mesh first, then what it is compared with"));
    const ended = this.#ended;
    try {
      const told = await take();
      if (ended !== this.#ended) throw new Superseded();
      this.#endSecond();
      this.#surface = take;
      this.#offered = offered;
      this.distances.forget();
      messages.settle("compare");
      facts.set({ comparison: told });
      if (told.surface?.notes.length)
        messages.say("note", told.surface.notes.join(" "), { topic: "compare" });
      const { other, picking } = store.defaults.compare;
      const compare = { other: { ...other, name: told.name }, picking };
      store.set({ compare: again ? compare : { ...compare, reference: { shown: true } } }, { undo: false });
      await drawing.update();
    } catch (error) {
      if (!(error instanceof Superseded)) messages.error(error, { topic: "compare" });
      throw error;
    }
  }

  /** @param {Error} error @returns {never} */
  #fail(error) {
    this.#app.messages.error(error, { topic: "compare" });
    throw error;
  }

  /** @template Answer @param {() => Promise<Answer>} ask @returns {Promise<Answer | null>} null if it failed, which was said */
  async #asked(ask) {
    try {
      return await ask();
    } catch (error) {
      if (!(error instanceof Superseded)) this.#app.messages.error(error, { topic: "compare" });
      return null;
    }
  }
}
