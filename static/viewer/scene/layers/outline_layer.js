import { Group } from "three";
import { boxOf } from "../../geometry/box.js";
import { LinesLayer } from "./lines_layer.js";

const INK = [{ colour: "#0b6e74", ink: 1 }];

/**
 * The edges of the cell that is meant: strong where they are in sight, fainter through everything before them.
 */
export class OutlineLayer {
  group = new Group();
  /** @type {import("../../geometry/box.js").Box | null} */
  box = null;
  #seen = new LinesLayer(INK);
  #through = new LinesLayer(INK, { seeThrough: true });

  constructor() {
    this.#seen.width = 2.5;
    this.#through.width = 2;
    this.#through.opacity = 0.6;
    this.group.add(this.#through.group, this.#seen.group);
    this.set(null);
  }

  /** @param {Float32Array | null} ends 6 numbers for each edge */
  set(ends) {
    this.box = ends && boxOf(ends);
    for (const lines of [this.#through, this.#seen]) {
      lines.set(ends ?? new Float32Array(0), null);
      lines.group.visible = ends !== null && ends.length > 0;
    }
  }

  /** @param {Parameters<LinesLayer["view"]>[0]} view */
  view(view) {
    for (const lines of [this.#through, this.#seen]) lines.view(view);
  }

  dispose() {
    this.#seen.dispose();
    this.#through.dispose();
  }
}
