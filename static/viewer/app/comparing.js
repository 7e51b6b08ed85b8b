import { CoreError, Superseded } from "../core/client.js";
import { areAlike, pointsIn } from "../state/frames.js";
import { quantityOf } from "../state/quantity.js";
import { hasAttribute } from "../state/opening_view.js";
import { tableCsv } from "../state/compared.js";
import { comparedOf } from "../state/tables.js";
import { groupsOf } from "../state/groups.js";
import { Distances } from "./distances.js";
import { saveFile } from "./saving.js";
import { fromFile } from "./opening.js";

/**
 * A second mesh beside the page's, under the one status, or a reference surface over it (SPEC S6, S7).
 *
 * @typedef {import("./side.js").Side} Side
 * @typedef {import("../state/second_store.js").SecondStore} SecondStore
 * @typedef {import("../state/origin.js").Origin} Origin
 * @typedef {Side & { store: SecondStore, close: () => void }} Second
 */

/** What is read of a file that is no mesh: a surface to measure against. */
const NO_MESH = ["NoCellsError", "MeshReadError"];

export class Comparing {
  #app;
  #make;
  /** @type {Second | null} */
  #second = null;
  /** The reference surface, to be taken again when the core was restarted. @type {{ name: string, bytes: Blob } | null} */
  #surface = null;
  #turn = 0;
  /** Settles when both meshes know of each other. @type {Promise<void>} */
  matched = Promise.resolve();

  /** @param {import("./app.js").App} app @param {(() => Second) | null} make what a second mesh is shown by; null where there can't be one */
  constructor(app, make) {
    this.#app = app;
    this.#make = make;
    this.distances = new Distances(app, this);
    const { store, facts } = app;
    app.opened = () => void this.#match();
    facts.on("statistics", () => this.#reach());
    store.on("colour", () => this.#reach());
    store.on("compare.colours", () => this.#reach());
    store.on("compare.camera", () => this.#place());
  }

  /** The second mesh; null while there is none. */
  get second() {
    return this.#second;
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
    const ending = /\.[^.]+$/.exec(file.name.replace(/\.gz$/i, ""))?.[0].toLowerCase() ?? "";
    const { surfaces, formats } = this.#app.tables;
    const known = (/** @type {readonly import("../state/tables.js").FormatRow[]} */ rows) =>
      rows.some(({ extensions }) => extensions.includes(ending));
    if (known(surfaces) && !known(formats)) return this.openSurface(file.name, file);
    const companions = async () =>
      Object.fromEntries(await Promise.all(parts.map(async (one) => [one.name, await one.arrayBuffer()])));
    const origin = { ...fromFile(file), ...(parts.length ? { companions } : {}) };
    await this.#open(origin, null, () => this.openSurface(file.name, file));
  }

  /** @param {string} source @param {string} mesh of the catalogue */
  async openEntry(source, mesh) {
    const entry = (await this.#app.catalogue)?.entry(source, mesh);
    if (!entry) return this.#fail(new Error(`the catalogue has no mesh ${source}/${mesh}`));
    const url = new URL(entry.mesh.url, document.baseURI).href;
    const origin = { ...this.#app.fetching.from(url, entry.mesh.sha256 ?? ""), entry };
    await this.#open(origin, `${source}/${mesh}`);
  }

  /** @param {string} address */
  async openUrl(address) {
    try {
      const whole = this.#app.meshAddress(address);
      await this.#open(this.#app.fetching.from(whole), whole);
    } catch (error) {
      if (!(error instanceof Superseded)) throw error;
    }
  }

  /** Compare with what the core has at hand. @param {string} id */
  async openOffered(id) {
    const offer = this.#app.facts.get("offers").find((one) => one.id === id);
    if (!offer) return this.#fail(new Error(`nothing is offered by the name of ${id}`));
    if (offer.surface) return this.#takeSurface(() => this.#app.client.call("compare_with_offered", [id]));
    await this.#open({ name: offer.name, offered: id }, null);
  }

  /** Measure against a surface, which is drawn over the mesh. @param {string} name @param {Blob} file */
  async openSurface(name, file) {
    await this.#takeSurface(async () => {
      const told = await this.#app.client.call("compare_with_surface", [name, await file.arrayBuffer()]);
      this.#surface = { name, bytes: file };
      return told;
    });
  }

  /** The second mesh, or the surface, goes. */
  close() {
    const { client, facts, store, look, scene, steps } = this.#app;
    this.#turn++;
    this.#surface = null;
    this.#second?.close();
    this.#second = null;
    facts.set({ comparison: null, second: null });
    this.distances.forget();
    look.derive((status) => status);
    scene.setBeside(null);
    steps.beside(null);
    const { defaults, status } = store;
    const { by, attribute } = status.colour;
    store.set(
      {
        compare: { other: defaults.compare.other, picking: defaults.compare.picking },
        ...(by === "attribute" && comparedOf(this.#app.tables, attribute)
          ? { colour: { by: "quality", attribute: "", range: null, map: defaults.colour.map } }
          : {}),
        ...(comparedOf(this.#app.tables, status.arrows.attribute) ? { arrows: { attribute: "" } } : {}),
        filters: {
          quality: {
            items: status.filters.quality.items.filter(
              ({ quantity }) => !comparedOf(this.#app.tables, quantity),
            ),
          },
        },
      },
      { undo: false },
    );
    if (facts.get("core") === "ready" && facts.get("summary"))
      client.call("stop_comparing").then(
        () => this.#app.drawing.update(),
        () => {}, // the core has ended, and what it compared with it
      );
  }

  /** Each mesh takes the place of the other. */
  async swap() {
    const second = this.#second;
    const [a, b] = [this.#app.opening.present, second?.opening.present];
    if (!second || !a || !b) return;
    const { store, steps } = this.#app;
    const { filters, compare } = store.status;
    const { enabled } = filters.picking;
    const same = this.#app.facts.get("comparison")?.same_cells ?? false;
    steps.swap();
    if (!same) {
      const { enabled: _, ...own } = filters.picking;
      store.set(
        { filters: { picking: { enabled, ...compare.picking } }, compare: { picking: own } },
        { undo: false },
      );
    }
    const stays = { status: undefined, layers: undefined, renewed: true };
    await Promise.all([
      this.#app.opening.open({ ...b, ...stays }),
      second.opening.open({ ...a, ...stays }),
    ]).catch(() => {}); // said in a message by whoever failed
  }

  /** Statistics of a quantity for both, asked for where they are not known yet. @param {string} id */
  async measure(id) {
    const sides = [this.#app, ...(this.#second ? [this.#second] : [])];
    await Promise.all(sides.map((side) => side.measures.know(id)));
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
    const sides = [this.#app, ...(this.#second ? [this.#second] : [])];
    await Promise.all(sides.map(({ structured }) => structured.trace()));
  }

  /** Bytes of memory that each core holds; null where that is not known. */
  get memory() {
    return [this.#app, ...(this.#second ? [this.#second] : [])].map(({ client }) => client.memory);
  }

  /** At how many cells a metric got worse; null where the cells are others. @param {string} metric */
  async changes(metric) {
    if (!this.#app.facts.get("comparison")?.same_cells) return null;
    return this.#asked(() => this.#app.client.call("metric_changes", [metric]));
  }

  /** @param {Origin} origin @param {string | null} address that names it @param {() => Promise<void>} [otherwise] where it is no mesh */
  async #open(origin, address, otherwise) {
    const { facts, steps } = this.#app;
    if (!facts.get("summary"))
      return this.#fail(new Error("Open a mesh first, then what it is compared with"));
    if (!this.#make) return this.#fail(new Error("A second mesh can't be shown here"));
    const began = this.#second === null;
    if (began) this.#begin(this.#make());
    const second = /** @type {Second} */ (this.#second);
    try {
      await second.opening.open(origin);
      this.#surface = null;
      steps.beside(address);
    } catch (error) {
      if (error instanceof Superseded || this.#second !== second) return;
      if (began) this.close();
      if (!otherwise || !(error instanceof CoreError) || !NO_MESH.includes(error.kind)) {
        this.#app.messages.error(error, { topic: "compare" });
        throw error;
      }
      second.messages.settle("open");
      await otherwise();
    }
  }

  /** @param {Second} second */
  #begin(second) {
    this.#second = second;
    second.opened = () => void this.#match();
    second.facts.on("statistics", () => this.#reach());
    second.facts.on("description", () => this.#know());
    second.facts.on("summary", () => this.#know());
    this.#app.facts.on("catalogue", (catalogue) => second.facts.set({ catalogue }));
    this.#app.facts.on("tool", (tool) => second.facts.set({ tool }));
    this.#app.facts.set({ second: second.facts });
  }

  /** What of the status the second mesh has. */
  #know() {
    const second = this.#second;
    const summary = second?.facts.get("summary");
    if (!second || !summary) return;
    const told = this.#app.facts.get("comparison");
    const groups = new Set(groupsOf(second.facts).map(({ id }) => id));
    second.store.know({
      same: told?.same_cells ?? false,
      cells: summary.cells,
      has: (quantity, components) => this.#has(summary, quantity, components),
      groups: (id) => groups.has(id),
    });
    this.#place();
  }

  /** @param {import("../state/facts.js").MeshSummary} summary @param {string} quantity @param {number} [components] */
  #has(summary, quantity, components) {
    const row = comparedOf(this.#app.tables, quantity);
    const told = this.#app.facts.get("comparison");
    if (row) return told !== null && (told.same_cells || !row.cellwise);
    if (quantity.startsWith("structure:")) return true;
    return hasAttribute(summary, quantity, components);
  }

  /** Whether both are seen at the same place, and by which frames. */
  #place() {
    const second = this.#second;
    const [a, b] = [this.#app.facts.get("summary"), second?.facts.get("summary")];
    if (!second || !a || !b) return;
    const { camera } = this.#app.store.status.compare;
    const together = camera === "same" || (camera === "auto" && areAlike(a, b));
    const [first, other] = [a, b].map(({ outline }) => outline ?? new Float32Array(0));
    this.#app.scene.setBeside(together ? pointsIn(other, b, a) : null);
    second.scene.setBeside(together ? pointsIn(first, a, b) : null);
    second.store.know({ frames: together ? { first: a, second: b } : null });
    this.#app.facts.set({ together });
  }

  /** The range of the values of both, where colours are common to them. */
  #reach() {
    const second = this.#second;
    if (!second) return;
    const { colours } = this.#app.store.status.compare;
    const { id } = quantityOf(this.#app);
    const known = [this.#app, second].map(({ facts }) => facts.get("statistics")[id]);
    const ends = known.flatMap((one) => [one?.min, one?.max]).filter((end) => typeof end === "number");
    /** @type {[number, number] | null} */
    const reach = colours === "common" && ends.length === 4 ? [Math.min(...ends), Math.max(...ends)] : null;
    this.#app.look.derive((status) => ({ ...status, colour: { ...status.colour, reach } }));
    second.store.know({ reach });
  }

  /** Have both cores know of the other's mesh. */
  #match() {
    this.matched = this.#matched(++this.#turn).catch((error) => {
      if (!(error instanceof Superseded)) this.#app.messages.error(error, { topic: "compare" });
    });
    return this.matched;
  }

  /** @param {number} turn */
  async #matched(turn) {
    const here = () => turn === this.#turn;
    this.distances.forget();
    if (this.#surface) {
      const { name, bytes } = this.#surface;
      return this.openSurface(name, bytes);
    }
    const [first, second] = [this.#app, this.#second];
    if (!second?.facts.get("summary") || !first.facts.get("summary")) return;
    if (second.facts.get("core") !== "ready" || first.facts.get("core") !== "ready") return;
    const pairs = /** @type {const} */ ([
      [first, second, true],
      [second, first, false],
    ]);
    const offered = pairs.map(([, other]) => other.facts.get("offered"));
    const marks = offered.every((one) => one !== null)
      ? null
      : await Promise.all(pairs.map(([side]) => side.client.call("fingerprint")));
    if (!here()) return;
    const handed =
      marks && (await Promise.all(pairs.map(([, other], k) => other.client.call("hand_over", [marks[k]]))));
    if (!here()) return;
    const [told] = await Promise.all(
      pairs.map(([side, , isFirst], k) => {
        if (!handed) return side.client.call("compare_with_offered", [offered[k] ?? "", isFirst]);
        const { points, triangles, coordinates, ...rest } = handed[k];
        const blocks = /** @type {const} */ ([
          bufferOf(points),
          bufferOf(triangles),
          coordinates && bufferOf(coordinates),
        ]);
        return side.client.call("compare_with", [rest, ...blocks, isFirst]);
      }),
    );
    if (!here()) return;
    first.facts.set({ comparison: told });
    this.#know();
    this.#reach();
    await Promise.all([first.drawing.update(), second.drawing.update()]);
  }

  /** @param {() => Promise<import("../state/answers.js").Compared>} take */
  async #takeSurface(take) {
    const { facts, messages, store, drawing } = this.#app;
    if (!facts.get("summary"))
      return this.#fail(new Error("Open a mesh first, then what it is compared with"));
    try {
      const told = await take();
      const surface = this.#surface;
      if (this.#second) this.close();
      this.#surface = surface;
      messages.settle("compare");
      facts.set({ comparison: told });
      if (told.surface?.notes.length)
        messages.say("note", told.surface.notes.join(" "), { topic: "compare" });
      store.set({ compare: { reference: { shown: true } } }, { undo: false });
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

/** A block of its own. @param {Float64Array | Int32Array} array @returns {ArrayBuffer} */
function bufferOf(array) {
  return /** @type {ArrayBuffer} */ (array.slice().buffer);
}
