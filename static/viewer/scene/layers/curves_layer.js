import { Group } from "three";
import { BASE_ROW, CURVE_STYLES, POINT_STYLES, arcStyles } from "../../colours/structure.js";
import { around, boxOf } from "../../geometry/box.js";
import { BallsLayer } from "./balls_layer.js";
import { LinesLayer } from "./lines_layer.js";

/** What is left of arcs and nodes beside those that were chosen. */
const FAINT = 0.22;

/** CSS pixels that curves are broad. */
const WIDTH = 2.4;

/**
 * Curves of the structure: arcs by valence with their nodes, chords, edges and vertices of the base complex.
 */
export class CurvesLayer {
  group = new Group();
  /** @type {import("../../geometry/box.js").Box | null} */
  box = null;
  #faintArcs = new LinesLayer(arcStyles("standard"));
  #arcs = new LinesLayer(arcStyles("standard"));
  #others = new LinesLayer(CURVE_STYLES);
  #faintBalls = new BallsLayer(POINT_STYLES);
  #balls = new BallsLayer(POINT_STYLES);

  constructor() {
    for (const lines of this.#lines) lines.width = WIDTH;
    this.#faintArcs.opacity = this.#faintBalls.opacity = FAINT;
    const [lines, balls] = [this.#lines.map((each) => each.group), this.#points.map((each) => each.points)];
    this.group.add(...lines, ...balls);
  }

  get #lines() {
    return [this.#faintArcs, this.#others, this.#arcs];
  }

  get #points() {
    return [this.#faintBalls, this.#balls];
  }

  /** @param {import("../../geometry/records.js").Curves | null} curves */
  set(curves) {
    this.box = curves && around([boxOf(curves.edges), boxOf(curves.points)]);
    const { edges, edge_rows, edge_faint, points, point_rows, point_faint } = curves ?? NOTHING;
    const lines = (
      /** @type {LinesLayer} */ layer,
      /** @type {(k: number) => boolean} */ which,
      first = 0,
    ) => {
      const found = picked(edges, edge_rows, 6, which);
      layer.set(
        found.values,
        found.rows.map((row) => row - first),
      );
      layer.group.visible = layer.count > 0;
    };
    lines(this.#arcs, (k) => edge_rows[k] < BASE_ROW && !edge_faint[k]);
    lines(this.#faintArcs, (k) => edge_rows[k] < BASE_ROW && edge_faint[k] > 0);
    lines(this.#others, (k) => edge_rows[k] >= BASE_ROW, BASE_ROW);
    const balls = (/** @type {BallsLayer} */ layer, /** @type {(k: number) => boolean} */ which) => {
      const found = picked(points, point_rows, 3, which);
      layer.set(found.values, found.rows);
    };
    balls(this.#balls, (k) => !point_faint[k]);
    balls(this.#faintBalls, (k) => point_faint[k] > 0);
  }

  /** @param {Parameters<typeof arcStyles>[0]} palette */
  set palette(palette) {
    for (const arcs of [this.#arcs, this.#faintArcs]) arcs.styles = arcStyles(palette);
  }

  /** @param {Parameters<LinesLayer["view"]>[0]} view */
  view(view) {
    for (const layer of [...this.#lines, ...this.#points]) layer.view(view);
  }

  dispose() {
    for (const layer of [...this.#lines, ...this.#points]) layer.dispose();
  }
}

/** @type {import("../../geometry/records.js").Curves} */
const NOTHING = {
  edges: new Float32Array(0),
  edge_rows: new Uint8Array(0),
  edge_faint: new Uint8Array(0),
  points: new Float32Array(0),
  point_rows: new Uint8Array(0),
  point_faint: new Uint8Array(0),
};

/**
 * Those of some things that are wanted.
 *
 * @param {Float32Array} values @param {Uint8Array} rows @param {number} width numbers of each @param {(k: number) => boolean} which
 */
function picked(values, rows, width, which) {
  const kept = Uint32Array.from(rows.keys()).filter(which);
  const out = new Float32Array(width * kept.length);
  kept.forEach((k, place) => out.set(values.subarray(width * k, width * (k + 1)), width * place));
  return { values: out, rows: Uint8Array.from(kept, (k) => rows[k]) };
}
