import { CoreError } from "../../../static/viewer/core/client.js";
import { merge } from "../../../static/viewer/state/paths.js";

/**
 * A core without Python, that knows meshes of our own making.
 *
 * @typedef {object} Body  what a file holds
 * @property {string} [cells] what its cells are: those of the same word are the same
 * @property {number} [count] of cells
 * @property {readonly number[]} [centre]
 * @property {number} [diagonal]
 * @property {readonly string[]} [attributes] their ids
 * @property {readonly [number, number]} [reach] of every quantity
 * @property {"no cells" | "broken"} [lacks] what keeps it from being a mesh
 * @property {boolean} [surface] whether it can be read as a surface
 * @property {string[]} [notes] of the surface
 */

/** @param {string} name @param {Body} [body] */
export const fileOf = (name, body = {}) => new File([JSON.stringify(body)], name);

/** Files that cores have at hand, by their ids. @typedef {Readonly<Record<string, { name: string, body: Body }>>} Offers */

/** A core: holds one mesh, and what that is compared with. */
export class Core extends EventTarget {
  ready = Promise.resolve({});
  milliseconds = {};
  memory = /** @type {number | null} */ (null);
  closed = false;
  /** @type {any[][]} */
  asked = [];
  /** @type {(Body & { name: string }) | null} */
  mesh = null;
  /** @type {string | null} */
  compared = null;
  identity = Promise.resolve({ sha256: "" });
  /** @type {Promise<unknown>} */
  #latest = Promise.resolve();
  /** @type {any} */
  #settings = {};
  /** Waits before a method is answered. @type {Record<string, Promise<unknown>>} */
  waits = {};
  /** Errors by method. @type {Record<string, Error>} */
  fails = {};

  /** @param {Offers} [offers] */
  constructor(offers = {}) {
    super();
    this.offers = offers;
  }

  dispose() {
    this.closed = true;
  }

  /** One question after the other. @param {string} method @param {any[] | (() => any[])} [args] */
  call(method, args = []) {
    const answer = this.#latest.then(() => this.#answer(method, typeof args === "function" ? args() : args));
    this.#latest = answer.catch(() => {});
    return answer;
  }

  /** @param {string} method @param {any[]} args */
  async #answer(method, args) {
    this.asked.push([method, ...args]);
    await this.waits[method];
    await new Promise((resolve) => setTimeout(resolve));
    if (this.closed) throw new CoreError({ kind: "WorkerError", message: "The core was closed." });
    if (this.fails[method]) throw this.fails[method];
    const answer = /** @type {any} */ (this)[`_${method}`];
    if (!answer) throw new Error(`this core is not asked ${method}`);
    return answer.apply(this, args);
  }

  /** Questions with a name, in order. @param {string} method */
  questions(method) {
    return this.asked.filter(([one]) => one === method).map(([, ...args]) => args);
  }

  /** @param {string} name @param {Body} body */
  #open(name, body) {
    if (body.lacks === "no cells")
      throw new CoreError({ kind: "NoCellsError", message: `${name}: no hexahedra` });
    if (body.lacks) throw new CoreError({ kind: "MeshReadError", message: `${name}: can't be read` });
    this.mesh = { ...body, name };
    this.compared = null;
    this.identity = Promise.resolve({ sha256: `hash of ${name}` });
    const { count = 8, centre = [0, 0, 0], diagonal = 1, attributes = [] } = body;
    const frame = [centre, centre.map((place) => place + diagonal / 3)];
    return {
      name,
      cells: count,
      framed_cells: count,
      centre,
      diagonal,
      extent: frame,
      frame,
      attributes: attributes.map((id) => ({ id, name: id, components: 1 })),
      outline: Float32Array.of(0.5, 0, 0, -0.5, 0, 0),
      view: { direction: [0, 0, -1], up: [0, 1, 0], facing: [1, 0, 0] },
      timings: {},
    };
  }

  /** @param {string} name @param {ArrayBuffer} bytes */
  _open(name, bytes) {
    return this.#open(name, JSON.parse(new TextDecoder().decode(bytes)));
  }

  /** @param {string} id */
  _open_offered(id) {
    return this.#open(this.offers[id].name, this.offers[id].body);
  }

  /** @param {string} name @param {ArrayBuffer} bytes */
  _compare_with_surface(name, bytes) {
    return this.#measureAgainst(name, JSON.parse(new TextDecoder().decode(bytes)));
  }

  /** @param {string} name @param {Body} body */
  #measureAgainst(name, { surface, notes = [] }) {
    if (!surface) throw new CoreError({ kind: "MeshReadError", message: `${name}: no surface` });
    return this.#compare(name, "", { triangles: 2, notes });
  }

  /** @param {string} name @param {string} cells @param {object | null} [surface] */
  #compare(name, cells, surface = null) {
    this.compared = name;
    return {
      name,
      same_cells: cells !== "" && cells === this.mesh?.cells,
      difference: "",
      surface,
      diagonal: 2,
    };
  }

  /** @param {string} id */
  _compare_with_offered(id) {
    const { name, body } = this.offers[id];
    return body.surface ? this.#measureAgainst(name, body) : this.#compare(name, body.cells ?? name);
  }

  /** @param {{ name: string, cells: string }} told */
  _compare_with({ name, cells }) {
    return this.#compare(name, cells);
  }

  _fingerprint() {
    return this.mesh?.cells ?? this.mesh?.name;
  }

  _hand_over() {
    const none = new Float64Array(3);
    const { name, cells = "others" } = this.mesh ?? { name: "" };
    return { name, cells, points: none, triangles: new Int32Array(3), coordinates: null };
  }

  _stop_comparing() {
    this.compared = null;
    return null;
  }

  /** @param {any} changed */
  _update(changed) {
    this.#settings = merge(this.#settings, changed);
    const { colour = {}, filters, arrows } = this.#settings;
    if (colour.by === "attribute") this.#know(colour.attribute);
    if (arrows?.attribute) this.#know(arrows.attribute);
    for (const { quantity } of filters?.quality?.items ?? []) this.#know(quantity);
    return { shown_cells: this.mesh?.count ?? 8, shown_faces: 6 };
  }

  /** @param {string} id of a quantity */
  #know(id) {
    if (/^(compare|change):/.test(id) && !this.compared) throw new Error("the mesh is compared with nothing");
    if (/^(cell|point):/.test(id) && !this.mesh?.attributes?.includes(id))
      throw new Error(`the mesh has no attribute ${id}`);
    return `${id} of ${this.mesh?.name} and ${this.compared}`;
  }

  _numbers() {
    return { first: 0, cells: null, vertices: null };
  }

  /** @param {string} id */
  _quality(id) {
    const [min, max] = this.mesh?.reach ?? [0, 1];
    return { min, max, percentiles: {}, of: this.#know(id) };
  }

  /** @param {string} quantity */
  _histogram(quantity) {
    const of = this.#know(quantity);
    return { quantity, edges: [0, 1], counts: [8], map_position: [0], low: 0, high: 1, of };
  }

  /** @param {string} id */
  _worst(id) {
    return { cells: [], values: [], places: [], not_finite: [], of: this.#know(id) };
  }

  /** @param {any} document */
  _check(document) {
    return { partial: document, rejections: [] };
  }
}
