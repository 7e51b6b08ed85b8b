import { Group } from "three";
import { boxOf } from "../../geometry/box.js";
import { LinesLayer } from "./lines_layer.js";

const INK = [{ colour: "#0b6e74", ink: 1 }];
const RIM = [{ colour: "#ffffff", ink: 1 }];

/** Strokes from the lowest to the topmost: a light rim lets the ink stand out from dark cells. */
const STROKES = [
  { styles: RIM, width: 4, opacity: 0.45, seeThrough: true },
  { styles: INK, width: 2, opacity: 0.6, seeThrough: true },
  { styles: RIM, width: 5.5, opacity: 0.9, seeThrough: false },
  { styles: INK, width: 2.5, opacity: 1, seeThrough: false },
];

/**
 * The edges of the cell that is meant: strong where they are in sight, fainter through everything before them.
 */
export class OutlineLayer {
  group = new Group();
  /** @type {import("../../geometry/box.js").Box | null} */
  box = null;
  #strokes = STROKES.map(({ styles, seeThrough, ...look }) =>
    Object.assign(new LinesLayer(styles, { seeThrough }), look),
  );

  constructor() {
    this.group.add(...this.#strokes.map(({ group }) => group));
    this.set(null);
  }

  /** @param {Float32Array | null} ends 6 numbers for each edge */
  set(ends) {
    this.box = ends && boxOf(ends);
    for (const lines of this.#strokes) {
      lines.set(ends ?? new Float32Array(0), null);
      lines.group.visible = ends !== null && ends.length > 0;
    }
  }

  /** @param {Parameters<LinesLayer["view"]>[0]} view */
  view(view) {
    for (const lines of this.#strokes) lines.view(view);
  }

  dispose() {
    for (const lines of this.#strokes) lines.dispose();
  }
}
