import { rightmostOf } from "./rightmost.js";

/**
 * The cell that is meant: tells where its rightmost corner stands on the canvas, whenever that has changed.
 */
export class Mark {
  /** Ends of its edges; null where none is meant. @type {Float32Array | null} */
  edges = null;
  /** Where it was told to stand. @type {import("../scene_like.js").Place | null} */
  #at = null;
  #told;

  /** @param {(at: import("../scene_like.js").Place | null) => void} told null: it is behind the eye, or there is none */
  constructor(told) {
    this.#told = told;
  }

  /** @param {import("three").Camera} camera @param {{ width: number, height: number }} size of the picture */
  look(camera, size) {
    const at = rightmostOf(this.edges ?? [], camera, size);
    if (at?.x === this.#at?.x && at?.y === this.#at?.y) return;
    this.#at = at;
    this.#told(at);
  }
}
