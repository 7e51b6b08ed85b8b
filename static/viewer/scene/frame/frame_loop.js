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
  #resting = false;

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
    if (this.#request === 0 && !this.#stopped && !this.#resting) {
      this.#request = requestAnimationFrame((now) => this.#turn(now));
    }
  }

  /** Draws what is asked for without waiting for the screen. */
  flush() {
    if (this.#stopped || this.#resting) return;
    this.#cancel();
    this.#turn(performance.now());
  }

  /** @param {boolean} stopped no picture can be drawn (context lost) */
  set stopped(stopped) {
    this.#stopped = stopped;
    if (stopped) this.#cancel();
    else this.invalidate();
  }

  /** @param {boolean} resting no picture is wanted: what is asked for waits */
  set resting(resting) {
    this.#resting = resting;
    if (resting) this.#cancel();
    else if (this.#stale) this.wake();
  }

  #cancel() {
    cancelAnimationFrame(this.#request);
    this.#request = 0;
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
