import { BufferAttribute, BufferGeometry } from "three";
import { flatQuadIndex } from "../geometry/quad_index.js";
import { DepthAtlas, depthMaterial } from "./depth_atlas.js";
import { DIRECTIONS, directions } from "./directions.js";
import { Gatherer } from "./gatherer.js";
import { lightView } from "./light_view.js";
import { platesOf } from "./plates.js";
import { meanSide } from "../geometry/mean_side.js";
import { gatheringPoints } from "./samples.js";
import { vertexTexel } from "../geometry/texel.js";

/** Pixels of the atlas's side. */
const ATLAS = 2048;

/** Directions from which the term is fit to be seen (the paper's six). */
export const ENOUGH = 6;

/**
 * Openness of every drawn vertex to light from 1024 directions, or fewer where told so, added up on the GPU a batch at a
 * time and never read back.
 *
 * @example
 * light.setSurface(surface, geometry);
 * while (!light.done) light.advance(16);
 */
export class ObjectSpaceAO {
  /** Directions gathered so far. */
  count = 0;
  #renderer;
  #most;
  #towards = directions();
  #gatherer = new Gatherer();
  /** Has the program of the depth maps, before there is one. */
  #depths = depthMaterial({ x: [], y: [], z: [] });
  /** @type {DepthAtlas | null} */
  #atlas = null;
  /** @type {import("three").BufferGeometry | null} */
  #geometry = null;
  /** @type {import("../geometry/records.js").Surface | null} */
  #surface = null;
  /** @type {ReturnType<typeof gatheringPoints> | null} */
  #points = null;
  /** How far off the surface its vertices gather light. */
  #lift = 0;
  /** What every view holds: the surface and the points lifted off it. @type {Float64Array} */
  #box = new Float64Array(6);
  /** @type {BufferGeometry | null} */
  #plates = null;

  /** @param {import("three").WebGLRenderer} renderer @param {number} [most] directions: a power of two up to 1024 */
  constructor(renderer, most = DIRECTIONS) {
    this.#renderer = renderer;
    this.#most = 2 ** Math.floor(Math.log2(Math.min(DIRECTIONS, Math.max(ENOUGH, most))));
  }

  /** By which it is drawn. The depth maps' is that of one that is made later: its program is the same. */
  get materials() {
    return [this.#gatherer.material, this.#depths];
  }

  /** All directions, three numbers each. */
  get directions() {
    return this.#towards;
  }

  get done() {
    return this.#surface === null || this.count >= this.#most;
  }

  get empty() {
    return this.#surface === null;
  }

  /** @returns {import("three").Texture} */
  get texture() {
    return this.#gatherer.texture;
  }

  /**
   * @param {import("../geometry/records.js").Surface | null} surface
   * @param {import("three").BufferGeometry} geometry
   */
  setSurface(surface, geometry) {
    this.#surface = surface && surface.faces.length > 0 ? surface : null;
    this.#geometry = geometry;
    this.#points = null;
    this.count = 0;
  }

  /** The GPU has forgotten everything: what lay there is made anew. */
  forget() {
    this.#gatherer.dispose();
    this.#gatherer = new Gatherer();
    this.#atlas?.dispose();
    this.#atlas = null;
    this.#points = null;
    this.count = 0;
  }

  #prepare() {
    const surface = /** @type {import("../geometry/records.js").Surface} */ (this.#surface);
    const plates = surface.mode === "rounded" ? platesOf(surface) : null;
    this.#points = gatheringPoints(surface, plates);
    const { box } = this.#points;
    const edge = meanSide(surface.positions, surface.quads, surface.faces.length);
    this.#gatherer.setPoints(this.#renderer, this.#points);
    const side = tileSide(box, plates ? 3 * edge : edge, surface);
    this.#lift = Math.min(plates ? 0.6 * plates.rounding : Infinity, diagonal(box) / side, 0.05 * edge);
    this.#box = box.map((value, k) => (k < 3 ? value - this.#lift : value + this.#lift));
    if (this.#atlas?.side !== side) {
      this.#atlas?.dispose();
      this.#atlas = new DepthAtlas(side, Math.min(4, Math.floor(ATLAS / side)));
    }
    this.#atlas.setGeometry(plates ? this.#plateGeometry(plates.corners) : this.#geometry);
  }

  /**
   * Gathers from so many more directions, fewer at the end or where an atlas holds fewer.
   *
   * @param {number} wanted
   * @returns {number} how many were done
   */
  advance(wanted) {
    if (this.done) return 0;
    if (!this.#points) this.#prepare();
    const atlas = /** @type {DepthAtlas} */ (this.#atlas);
    const points = /** @type {ReturnType<typeof gatheringPoints>} */ (this.#points);
    const first = this.count;
    let count = Math.min(atlas.columns ** 2, 2 ** Math.floor(Math.log2(Math.max(1, wanted))));
    while (first % count !== 0) count /= 2; // so that a batch ends at every power of two
    const views = [];
    for (let k = first; k < first + count; k++) {
      views.push(lightView(this.#towards.subarray(3 * k, 3 * k + 3), this.#box, 2 / atlas.side));
    }
    atlas.draw(this.#renderer, views, first);
    this.#gatherer.gather(this.#renderer, atlas, this.#towards, {
      first,
      count,
      lift: this.#lift,
      rows: points.rows,
    });
    this.count += count;
    return count;
  }

  /** @param {Float32Array} corners @returns {BufferGeometry} */
  #plateGeometry(corners) {
    this.#dropPlates();
    this.#plates = new BufferGeometry();
    this.#plates.setAttribute("position", new BufferAttribute(corners, 3));
    this.#plates.setIndex(flatQuadIndex(corners.length / 12));
    this.#plates.setDrawRange(0, corners.length / 2);
    return this.#plates;
  }

  #dropPlates() {
    this.#plates?.setIndex(null); // shared with the surface
    this.#plates?.dispose();
    this.#plates = null;
  }

  /** Openness of every drawn vertex, read back, for files. @returns {Float32Array} */
  read() {
    const points = /** @type {ReturnType<typeof gatheringPoints>} */ (this.#points);
    const surface = /** @type {import("../geometry/records.js").Surface} */ (this.#surface);
    return openness(this.#gatherer.read(this.#renderer, points.rows), surface.positions.length / 3);
  }

  dispose() {
    this.#depths.dispose();
    this.#gatherer.dispose();
    this.#atlas?.dispose();
    this.#dropPlates();
  }
}

/**
 * Pixels of a view's side: enough that a face covers some of them and, where cells stand apart, that a gap does as far as time
 * allows.
 *
 * @param {Float64Array} box extent of the surface
 * @param {number} edge mean side of a face
 * @param {import("../geometry/records.js").Surface} surface
 * @returns {number}
 */
function tileSide(box, edge, { mode, faces }) {
  const apart = mode === "fissure";
  const wanted = 64 * Math.ceil(((apart ? 24 : 3) * diagonal(box)) / edge / 64);
  return Math.max(192, Math.min(wanted, apart && faces.length < 12000 ? 1024 : 512));
}

/** @param {Float64Array} box @returns {number} */
function diagonal(box) {
  return Math.hypot(box[3] - box[0], box[4] - box[1], box[5] - box[2]);
}

/**
 * @param {Uint32Array} sums four words per texel
 * @param {number} vertices
 * @returns {Float32Array} 0 closed to 1 open, per drawn vertex
 */
function openness(sums, vertices) {
  const out = new Float32Array(vertices);
  for (let v = 0; v < vertices; v++) {
    const at = 4 * vertexTexel(v);
    out[v] = sums[at + 1] === 0 ? 1 : Math.max(sums[at], sums[at + 2]) / sums[at + 1];
  }
  return out;
}
