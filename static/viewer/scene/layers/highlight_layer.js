import { Group } from "three";
import { FlatLayer } from "./flat_layer.js";
import { LinesLayer } from "./lines_layer.js";

/**
 * The face under the pointer, tinted and rimmed.
 */
export class HighlightLayer {
  group = new Group();
  #fill = new FlatLayer("#0b6e74", 0.3, { raised: true });
  #rim = new LinesLayer([{ colour: "#0b6e74", ink: 1 }]);
  /** @type {number | null} */
  #face = null;

  constructor() {
    this.#rim.width = 2;
    this.group.add(this.#fill.mesh, this.#rim.group);
    this.group.visible = false;
  }

  /**
   * @param {import("../../geometry/records.js").Surface | null} surface
   * @param {number | null} face tag: cell * 8 + local face
   * @returns {boolean} whether the picture changes
   */
  set(surface, face) {
    if (face === this.#face) return false;
    this.#face = face;
    const { triangles, rim } = surface && face !== null ? outline(surface, face) : { triangles: [], rim: [] };
    this.group.visible = triangles.length > 0;
    if (this.group.visible) {
      this.#fill.set(new Float32Array(triangles));
      this.#rim.set(new Float32Array(rim), null);
      this.#rim.group.visible = true;
    }
    return true;
  }

  /** @param {Parameters<LinesLayer["view"]>[0]} view */
  view(view) {
    this.#rim.view(view);
  }

  dispose() {
    this.#fill.dispose();
    this.#rim.dispose();
  }
}

/**
 * Triangles of a face, and those of its quads' sides that only one quad has.
 *
 * @param {import("../../geometry/records.js").Surface} surface
 * @param {number} face
 * @returns {{ triangles: number[], rim: number[] }} coordinates
 */
function outline({ faces, quads, positions }, face) {
  const triangles = [];
  /** @type {Map<string, [number, number]>} */
  const sides = new Map();
  for (let row = faces.indexOf(face); row >= 0; row = faces.indexOf(face, row + 1)) {
    const ids = [0, 1, 2, 3].map((k) => (quads ? quads[4 * row + k] : 4 * row + k));
    for (const k of [0, 1, 2, 0, 2, 3]) triangles.push(...at(positions, ids[k]));
    for (let k = 0; k < 4; k++) {
      const [a, b] = [ids[k], ids[(k + 1) & 3]];
      if (at(positions, a).join() === at(positions, b).join()) continue;
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      if (!sides.delete(key)) sides.set(key, [a, b]);
    }
  }
  const rim = [...sides.values()].flatMap(([a, b]) => [...at(positions, a), ...at(positions, b)]);
  return { triangles, rim };
}

/** @param {Float32Array} positions @param {number} vertex @returns {number[]} */
function at(positions, vertex) {
  return [...positions.subarray(3 * vertex, 3 * vertex + 3)];
}
