import { Cells } from "./cells.js";
import { Drawing } from "./drawing.js";
import { Fetching } from "./fetching.js";
import { Grouped } from "./grouped.js";
import { Measures } from "./measures.js";
import { Messages } from "./messages.js";
import { Opening } from "./opening.js";
import { Progress } from "./progress.js";
import { Structured } from "./structured.js";
import { Views } from "./views.js";
import { Look } from "../state/look.js";

/**
 * One mesh on one canvas, with a core of its own: what is known of it, how it is drawn, what can be done to its cells. The
 * page's mesh is one (`App`), a second one beside it another.
 *
 * @typedef {object} Parts
 * @property {import("../state/store.js").StatusStore} store
 * @property {import("../state/facts.js").Facts} facts
 * @property {import("../core/client.js").CoreClient} client
 * @property {import("../scene/scene_like.js").SceneLike} scene
 * @property {import("../state/tables.js").Tables} tables
 * @property {HTMLCanvasElement} canvas
 * @property {Omit<import("../hosts/host.js").Host, "client" | "addressed" | "beside" | "another">} host
 *
 * @typedef {import("../state/origin.js").Origin} Origin
 * @typedef {import("../state/facts.js").MeshSummary} MeshSummary
 * @typedef {import("../widgets/bind.js").CellActions} CellActions
 *
 * @implements {CellActions}
 */
export class Side {
  /** @param {Parts} parts @param {Messages} [messages] that are told of this mesh */
  constructor({ store, facts, client, scene, tables, canvas, host }, messages = new Messages(facts)) {
    this.store = store;
    this.facts = facts;
    this.client = client;
    this.scene = scene;
    this.tables = tables;
    this.canvas = canvas;
    this.host = host;
    this.ahead = host.ahead;
    this.messages = messages;
    this.progress = new Progress(facts);
    this.look = new Look(store);
    this.drawing = new Drawing(this);
    this.measures = new Measures(this);
    this.cells = new Cells(this);
    this.grouped = new Grouped(this);
    this.structured = new Structured(this);
    this.fetching = new Fetching(this);
    this.opening = new Opening(this);
    this.views = new Views(this);
  }

  /** Follow the core's life, from its start on. */
  followCore() {
    const { client, facts, messages } = this;
    client.ready.then(
      (/** @type {import("../core/client.js").Start} */ start) => {
        this.note({ ...start });
        facts.set({ core: "ready" });
      },
      () => facts.set({ core: "failed" }),
    );
    client.addEventListener("died", () => {
      this.drawing.pause();
      facts.set({ core: "starting" });
      messages.say("warning", "The core stopped and is being started again", { topic: "core" });
    });
    client.addEventListener("restarted", () => this.#restarted());
    client.addEventListener("stopped", (event) => {
      const { error } = /** @type {CustomEvent<{ error: Error }>} */ (event).detail;
      this.drawing.pause();
      facts.set({ core: "failed" });
      messages.say("error", `The core stopped again and was left alone: ${error.message}`, {
        topic: "core",
        action: { name: "start it again", press: () => client.restart() },
      });
    });
  }

  async #restarted() {
    this.facts.set({ core: "ready" });
    try {
      await this.opening.reopen();
      this.messages.say("note", "The core stopped and was started again; the mesh is open as before", {
        topic: "core",
      });
    } catch (error) {
      this.messages.error(error, { topic: "core" });
    }
  }

  /**
   * Take on the settings that a mesh opens under, before it is drawn.
   *
   * @param {Origin} _origin @param {MeshSummary} _summary @returns {boolean} whether the view is that of the mesh before
   */
  adopt(_origin, _summary) {
    return false;
  }

  /** Pictures of meshes that are on their way, where there is a place for them. @type {import("./portraits.js").Portraits | null} */
  portraits = null;

  /** The core has taken a mesh: what it was told of others is gone. @type {() => void} */
  taken = () => {};

  /** The core holds the mesh that is on the screen: another than before, or the same once more. @type {() => void} */
  opened = () => {};

  /** Apply the documents that came with a mesh. @param {Pick<Origin, "layers" | "status">} _origin */
  async dress(_origin) {}

  /** Keep times for `timings()`. @param {Record<string, number | undefined>} times milliseconds */
  note(times) {
    const timings = { ...this.facts.get("timings") };
    for (const [name, value] of Object.entries(times)) if (value !== undefined) timings[name] = value;
    this.facts.set({ timings });
  }

  /** @param {number | null} cell */
  inspect(cell) {
    return this.cells.inspect(cell);
  }

  /** @param {number} cell */
  flyTo(cell) {
    return this.cells.flyTo(cell);
  }

  /** @param {number} cell */
  cutTo(cell) {
    return this.cells.cutTo(cell);
  }

  /** @param {import("../state/facts.js").PickingTool} action @param {number} cell */
  pick(action, cell) {
    this.cells.pick(action, cell);
  }

  /** @param {"cell" | "vertex"} kind @param {number} number of the file */
  goTo(kind, number) {
    return this.cells.goTo(kind, number);
  }

  /** @param {readonly number[]} cells rows @param {string} form @param {string} name */
  listCells(cells, form, name) {
    return this.cells.list(cells, form, name);
  }

  /** @param {{ id: string, message: string }} finding */
  showFinding(finding) {
    return this.cells.showFinding(finding);
  }
}
