import { Group } from "three";
import { around, boxOf } from "../../geometry/box.js";
import { LinesLayer, SHORTENED } from "./lines_layer.js";
import { PaperLayer } from "./paper_layer.js";
import { VALENCE_STYLES, valenceStyle } from "../../colours/valence.js";

/**
 * What each step of the slider draws: opacity of wires, barbs and paper, each tested against the model's depth and then seen
 * through it.
 */
const STEPS = [
  { wires: [0, 0], barbs: [0, 0], paper: [0, 0] },
  { wires: [1, 0], barbs: [0, 0], paper: [0, 0] },
  { wires: [1, 0.35], barbs: [0, 0], paper: [0, 0] },
  { wires: [1, 0], barbs: [1, 0], paper: [0, 0] },
  { wires: [1, 0.35], barbs: [1, 0.3], paper: [0, 0] },
  { wires: [0, 0], barbs: [0, 0], paper: [1, 0] },
  { wires: [0, 0], barbs: [0, 0], paper: [1, 0.3] },
];

/** What shortens a wire whose first, second, or both ends lie on the boundary. */
const DIVES = [0, SHORTENED[0], SHORTENED[1], SHORTENED[0] + SHORTENED[1]];

const INK = [{ colour: "#000000", ink: 1 }];

/** Edges up to which wires are as broad as they can be. */
const FEW = 400;

/** Least part of their width, and of their ink, that wires keep however many they are. */
const THINNEST = 0.4;
const FAINTEST = 0.08;

/**
 * How broad wires are, and how much ink they have, 0 to 1: they thin with their number, and fade where they are many more than
 * the faces that they stand among.
 *
 * @param {number} edges
 * @param {number} faces that are shown
 */
export function crowding(edges, faces) {
  const width = Math.max(THINNEST, Math.min(1, (FEW / Math.max(1, edges)) ** 0.25));
  const ink = Math.max(FAINTEST, Math.min(1, Math.sqrt((2 * faces) / Math.max(1, edges))));
  return { width, ink };
}

/** @type {import("../../geometry/records.js").Irregular} */
const NOTHING = {
  edges: new Float32Array(0),
  valence: new Uint8Array(0),
  boundary: new Uint8Array(0),
  ends_on_boundary: new Uint8Array(0),
  barbs: new Float32Array(0),
  barb_valence: new Uint8Array(0),
  barb_boundary: new Uint8Array(0),
  paper: new Float32Array(0),
  paper_valence: new Uint8Array(0),
  paper_boundary: new Uint8Array(0),
  counts: {},
};

/**
 * The irregular edges in seven steps, from nothing to paper flaps seen through the mesh.
 */
export class IrregularLayer {
  group = new Group();
  #wires = pair((seeThrough) => new LinesLayer(styles("wire", "standard"), { seeThrough }));
  #barbs = pair((seeThrough) => new LinesLayer(styles("barb", "standard"), { seeThrough }));
  #folds = pair((seeThrough) => new LinesLayer(INK, { seeThrough }));
  #paper = pair((seeThrough) => new PaperLayer({ seeThrough }));
  /** Of all edges. @type {import("../../geometry/box.js").Box | null} */
  box = null;
  #faces = 0;
  /** @type {Palette} */
  #palette = "standard";
  #mode = 1;
  #boundary = false;
  /** @type {import("../../geometry/records.js").Irregular | null} */
  #irregular = null;

  constructor() {
    const layers = [this.#paper, this.#folds, this.#barbs, this.#wires];
    for (const through of [1, 0]) for (const layer of layers) this.group.add(drawn(layer[through]));
    // Not pulled: ends that dive into the surface would show as dots.
    for (const lines of [...this.#wires, ...this.#barbs, ...this.#folds]) lines.pull = 0;
  }

  /** @param {import("../../geometry/records.js").Irregular | null} irregular */
  set(irregular) {
    this.#irregular = irregular;
    this.box = irregular && around([boxOf(irregular.edges), boxOf(irregular.barbs), boxOf(irregular.paper)]);
    const rows = (/** @type {Uint8Array} */ boundary) =>
      this.#boundary ? boundary.length : boundary.indexOf(1);
    const part = (
      /** @type {Float32Array} */ ends,
      /** @type {Uint8Array} */ valence,
      /** @type {number} */ count,
    ) => {
      const n = count < 0 ? valence.length : count; // those of the boundary stand last
      return {
        ends: ends.subarray(0, (ends.length / (valence.length || 1)) * n),
        styles: valence.subarray(0, n).map(valenceStyle),
      };
    };
    const {
      edges,
      valence,
      boundary,
      ends_on_boundary,
      barbs,
      barb_valence,
      barb_boundary,
      paper,
      paper_valence,
      paper_boundary,
    } = irregular ?? NOTHING;
    const wires = part(edges, valence, rows(boundary));
    const thorns = part(barbs, barb_valence, rows(barb_boundary));
    const flaps = part(paper, paper_valence, rows(paper_boundary));
    // Ends of wires that dive into the body's boundary would dot it; those that lie on it have no ends there.
    const dives = wires.styles.map((style, k) => style + (boundary[k] ? 0 : DIVES[ends_on_boundary[k]]));
    for (const lines of [...this.#wires, ...this.#folds]) lines.set(wires.ends, dives);
    for (const lines of this.#barbs) lines.set(thorns.ends, thorns.styles);
    for (const layer of this.#paper) layer.set(flaps.ends, flaps.styles);
    this.#show();
  }

  /** @param {Palette} palette @typedef {keyof typeof VALENCE_STYLES} Palette */
  setPalette(palette) {
    if (palette === this.#palette) return;
    this.#palette = palette;
    for (const wire of this.#wires) wire.styles = styles("wire", palette);
    for (const barb of this.#barbs) barb.styles = styles("barb", palette);
    for (const paper of this.#paper) paper.palette = palette;
    this.set(this.#irregular);
  }

  /** @param {number} mode 0 to 6 @param {boolean} boundary draw irregular edges of the boundary too */
  setMode(mode, boundary) {
    this.#mode = Math.min(STEPS.length - 1, Math.max(0, Math.round(mode)));
    if (boundary !== this.#boundary) {
      this.#boundary = boundary;
      this.set(this.#irregular);
    }
    this.#show();
  }

  /** Faces that are shown, among which the edges stand. @param {number} faces */
  set among(faces) {
    if (faces === this.#faces) return;
    this.#faces = faces;
    this.#show();
  }

  #show() {
    const step = STEPS[this.#mode];
    const { width, ink } = crowding(this.#wires[0].count, this.#faces);
    // Thin between barbs, which a broad wire would swallow.
    for (const wire of this.#wires) wire.width = (step.barbs[0] > 0 ? 1.25 : 1.75) * width;
    for (const barb of this.#barbs) barb.width = width;
    for (const fold of this.#folds) fold.width = 1.5 * width;
    for (const through of [0, 1]) {
      show(this.#wires[through], ink * step.wires[through]);
      show(this.#barbs[through], ink * step.barbs[through]);
      show(this.#paper[through], ink * step.paper[through]);
      show(this.#folds[through], ink * (through ? step.paper[1] / 3 : step.paper[0]));
    }
  }

  /** @param {Parameters<LinesLayer["view"]>[0]} view */
  view(view) {
    for (const lines of [...this.#wires, ...this.#barbs, ...this.#folds]) lines.view(view);
  }

  dispose() {
    for (const layer of [...this.#wires, ...this.#barbs, ...this.#folds, ...this.#paper]) layer.dispose();
  }
}

/**
 * @template T
 * @param {(seeThrough: boolean) => T} make
 * @returns {[T, T]} tested against depth, and seen through
 */
function pair(make) {
  return [make(false), make(true)];
}

/** @param {"wire" | "barb"} part @param {Palette} palette */
function styles(part, palette) {
  return VALENCE_STYLES[palette].map((row) => ({
    colour: row[part],
    ink: 1,
    width: part === "wire" ? row.width : 1,
  }));
}

/** @param {LinesLayer | PaperLayer} layer @param {number} opacity */
function show(layer, opacity) {
  drawn(layer).visible = opacity > 0 && layer.count > 0;
  layer.opacity = opacity;
}

/** @param {LinesLayer | PaperLayer} layer */
function drawn(layer) {
  return layer instanceof LinesLayer ? layer.group : layer.mesh;
}
