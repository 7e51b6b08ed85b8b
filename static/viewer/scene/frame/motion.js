/** Milliseconds after the last change during which the user counts as busy. */
const BUSY = 160;

/** The same while a button of the pointer is down, for a GPU too slow to draw whole pictures meanwhile. */
const HELD = 600;

/** Milliseconds after a new surface before such a GPU gathers light on it: another may be on its way. */
const STILL = 120;

/**
 * Whether something moves, and whether the GPU can follow: what is drawn, and how much of it, hangs on that.
 */
export class Motion {
  /** Whether a button of the pointer is down, on a slider as well as on the drawing. */
  held = false;
  #slow;
  #changed = 0;
  #surfaced = 0;

  /**
   * @param {{ slow: () => boolean, released: () => void }} told whether whole pictures take too long to draw one for every move;
   *   to be called when no button is down any more
   * @param {AbortSignal} signal
   */
  constructor({ slow, released }, signal) {
    this.#slow = slow;
    const options = { signal, capture: true };
    const hold = (/** @type {boolean} */ held) => {
      this.held = held;
      if (!held) released();
    };
    for (const name of ["pointerdown", "pointerup", "pointercancel"])
      window.addEventListener(name, () => hold(name === "pointerdown"), options);
    // A button let go outside of the window tells nobody.
    const moved = (/** @type {PointerEvent} */ { buttons }) =>
      void (this.held && buttons === 0 && hold(false));
    window.addEventListener("pointermove", moved, options);
  }

  /** Something has changed. */
  touch() {
    this.#changed = performance.now();
  }

  /** There is another surface. */
  surfaced() {
    this.#surfaced = performance.now();
    this.touch();
  }

  /** Whether the GPU is too slow to draw a whole picture for every move. */
  get slow() {
    return this.#slow();
  }

  /** Whether surfaces are wanted fast rather than whole. */
  get hurried() {
    return this.held && this.slow;
  }

  /** @param {number} now */
  busy(now) {
    return now - this.#changed < (this.hurried ? HELD : BUSY);
  }

  /** Whether the surface has stood for long enough to be lit. @param {number} now */
  still(now) {
    return now - this.#surfaced > (this.held ? HELD : STILL);
  }
}
