/**
 * Draws when asked, once for however many askings, and never at rest. Work that goes on between pictures (lighting) returns
 * true from its step for as long as it wants another turn.
 */
export class FrameLoop {
  frames = 0;
  #draw;
  #step;
  #request = 0;
  #stale = false;
  #stopped = false;

  /**
   * @param {() => void} draw
   * @param {(now: number) => { again: boolean, draw: boolean }} step called once a turn before drawing
   */
  constructor(draw, step) {
    this.#draw = draw;
    this.#step = step;
  }

  /** Whether a picture is asked for and not yet drawn. */
  get stale() {
    return this.#stale;
  }

  /** Asks for a picture. */
  invalidate() {
    this.#stale = true;
    this.wake();
  }

  /** Asks for a turn of the step, with or without a picture after it. */
  wake() {
    if (this.#request === 0 && !this.#stopped) {
      this.#request = requestAnimationFrame((now) => this.#turn(now));
    }
  }

  /** Draws what is asked for without waiting for the screen. */
  flush() {
    if (this.#stopped) return;
    cancelAnimationFrame(this.#request);
    this.#request = 0;
    this.#turn(performance.now());
  }

  /** @param {boolean} stopped no picture can be drawn (context lost) */
  set stopped(stopped) {
    this.#stopped = stopped;
    if (stopped) {
      cancelAnimationFrame(this.#request);
      this.#request = 0;
    } else this.invalidate();
  }

  /** @param {number} now */
  #turn(now) {
    this.#request = 0;
    const { again, draw } = this.#step(now);
    if (draw || this.#stale) {
      this.#stale = false;
      this.frames++;
      this.#draw();
    }
    if (again) this.wake();
  }
}
