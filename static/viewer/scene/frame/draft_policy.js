import { Motion } from "./motion.js";
import { Pace } from "./pace.js";

/**
 * When a draft is drawn instead of a whole picture: while something moves, if the GPU is too slow to draw a whole one for
 * every move.
 *
 * @example
 * const draft = drafts.begin(performance.now(), ready);
 * drawPicture(draft);
 * drafts.end();
 */
export class DraftPolicy {
  #pace;
  #motion;
  #turning;
  #calm;
  /** Whether the canvas shows a draft. */
  #shown = false;

  /**
   * @param {WebGL2RenderingContext} gl
   * @param {object} scene
   * @param {() => number} scene.faces of the surface
   * @param {() => boolean} scene.turning whether the pointer holds the model at this moment
   * @param {() => void} scene.calm told when nothing is held any more, or has not moved for long
   * @param {AbortSignal} signal
   */
  constructor(gl, { faces, turning, calm }, signal) {
    this.#pace = new Pace(gl);
    this.#motion = new Motion({ slow: () => this.#pace.slow(faces()), released: calm }, signal);
    this.#turning = turning;
    this.#calm = calm;
  }

  /** Whether surfaces are wanted fast rather than whole. */
  get hurried() {
    return this.#motion.hurried;
  }

  /** Whether a button of the pointer is down, on a slider as well as on the drawing. */
  get held() {
    return this.#motion.held;
  }

  /** Something has changed. */
  touch() {
    this.#motion.touch();
  }

  /** There is another surface. */
  surfaced() {
    this.#motion.surfaced();
  }

  /** There is another mesh: how long pictures of the last one took says nothing of it. */
  forget() {
    this.#pace.forget();
  }

  /** @param {number} now */
  #busy(now) {
    return this.#turning() || this.#motion.busy(now);
  }

  /** A picture is to be drawn. @param {number} now @param {boolean} ready whether a whole one can be @returns {boolean} whether as a draft */
  begin(now, ready) {
    this.#shown = !ready || (this.#busy(now) && this.#motion.slow);
    return this.#shown;
  }

  /** The picture's commands have been given. */
  end() {
    if (!this.#shown) this.#pace.watch();
  }

  /**
   * One turn between pictures.
   *
   * @param {number} now
   * @param {(busy: boolean, slow: boolean) => { again: boolean, draw: boolean }} gather gathers light, unless another thing
   *   goes first
   * @returns {{ again: boolean, draw: boolean }} whether another turn, and a picture, are wanted
   */
  step(now, gather) {
    const { held, slow } = this.#motion;
    const busy = this.#busy(now);
    // A slow GPU does one large thing at a time, so that the next move finds it free soon, and gathers no light on a
    // surface that another follows.
    if (slow && (this.#pace.watching || (busy && !this.#motion.still(now))))
      return { again: true, draw: false };
    if (this.#shown && held && !busy) this.#calm();
    const { again, draw } = gather(busy, slow);
    return { again: again || this.#shown, draw: draw || (this.#shown && !busy) };
  }
}
