import { isSoftware } from "./software.js";

/** Milliseconds that the GPU may take for a whole picture before moving ones are drawn as drafts. */
const LIMIT = 34;

/** Pictures that must have been timed before their times count more than the GPU's name: the first ones compile shaders. */
const TIMED = 3;

/** Faces of a surface that the processor draws too slowly to follow a hand. */
const MANY = 4000;

/**
 * How long the GPU takes for whole pictures: whether it can draw one for every move of the hand.
 *
 * @example
 * if (moving && pace.slow(faces)) drawDraft();
 * else { drawWhole(); pace.watch(); }
 */
export class Pace {
  #gl;
  #software;
  /** Whether the GPU is at work on a whole picture. */
  watching = false;
  /** @type {number[]} */
  #times = [];

  /** @param {WebGL2RenderingContext} gl */
  constructor(gl) {
    this.#gl = gl;
    this.#software = isSoftware(gl);
  }

  /** @param {number} faces of the surface @returns {boolean} */
  slow(faces) {
    if (this.#times.length < TIMED) return this.#software && faces > MANY;
    return Math.min(...this.#times) > LIMIT;
  }

  /** Another mesh: what was timed says nothing of it. */
  forget() {
    this.#times = [];
  }

  /** Times the whole picture whose commands have just been given. */
  watch() {
    if (this.watching) return;
    const gl = this.#gl;
    const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    if (!sync) return;
    gl.flush();
    this.watching = true;
    const began = performance.now();
    const times = this.#times;
    const look = () => {
      const waiting = !gl.isContextLost() && gl.clientWaitSync(sync, 0, 0) === gl.TIMEOUT_EXPIRED;
      if (waiting && performance.now() - began < 2000) return void setTimeout(look, 4);
      gl.deleteSync(sync);
      this.watching = false;
      times.push(performance.now() - began);
      if (times.length > TIMED) times.shift();
    };
    setTimeout(look, 4);
  }
}
