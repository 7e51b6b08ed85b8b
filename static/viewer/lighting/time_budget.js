/**
 * How much work a turn may give to the GPU: found by whether the GPU had finished the last lot when the screen came round
 * again. It doubles while the GPU keeps up and halves when it does not.
 */
export class TimeBudget {
  /** Work units for the next turn. */
  size = 8;
  #gl;
  #most;
  /** @type {{ sync: WebGLSync, turns: number, size: number }[]} */
  #flying = [];

  /** @param {WebGL2RenderingContext} gl @param {number} most work units that one turn may ever have */
  constructor(gl, most) {
    this.#gl = gl;
    this.#most = most;
  }

  /**
   * To be asked once a turn: may more work be given?
   *
   * @param {boolean} busy the user holds the model: keep well within one turn of the screen
   * @returns {boolean}
   */
  ready(busy) {
    const gl = this.#gl;
    for (const lot of this.#flying) lot.turns++;
    while (this.#flying.length > 0) {
      const [{ sync, turns, size }] = this.#flying;
      const state = gl.clientWaitSync(sync, 0, 0);
      if (state === gl.TIMEOUT_EXPIRED && turns < 120) break;
      gl.deleteSync(sync);
      this.#flying.shift();
      const allowed = busy ? 1 : 2;
      if (turns <= allowed - (busy ? 0 : 1)) this.size = Math.min(this.#most, Math.max(this.size, size * 2));
      else if (turns > allowed) this.size = Math.max(1, Math.min(this.size, size / 2));
    }
    return this.#flying.length < (busy ? 1 : 2);
  }

  /** Tells that work of a size was just given. @param {number} size */
  given(size) {
    const gl = this.#gl;
    const sync = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    if (sync) this.#flying.push({ sync, turns: 0, size });
  }

  /** Forgets what was given: the context is new. */
  reset() {
    this.#flying = [];
  }
}
