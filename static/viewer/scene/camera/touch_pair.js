/**
 * Two fingers: how far their middle moved, how they spread and turned.
 */
export class TouchPair {
  /** @type {Map<number, { x: number, y: number }>} */
  #fingers = new Map();

  get both() {
    return this.#fingers.size === 2;
  }

  /** @param {number} id @param {{ x: number, y: number }} place @returns {boolean} whether two fingers are down now */
  add(id, place) {
    if (this.#fingers.size < 2) this.#fingers.set(id, place);
    return this.both;
  }

  /** @param {number} id */
  remove(id) {
    this.#fingers.delete(id);
  }

  /**
   * @param {number} id
   * @param {{ x: number, y: number }} place
   * @returns {{ dx: number, dy: number, scale: number, roll: number, x: number, y: number } | null}
   */
  move(id, place) {
    if (!this.#fingers.has(id)) return null;
    const before = this.#shape();
    this.#fingers.set(id, place);
    if (!before) return null;
    const after = this.#shape() ?? before;
    return {
      dx: after.x - before.x,
      dy: after.y - before.y,
      scale: before.length > 0 ? after.length / before.length : 1,
      roll: Math.atan2(Math.sin(before.angle - after.angle), Math.cos(before.angle - after.angle)),
      x: after.x,
      y: after.y,
    };
  }

  #shape() {
    if (!this.both) return null;
    const [a, b] = [...this.#fingers.values()];
    return {
      x: (a.x + b.x) / 2,
      y: (a.y + b.y) / 2,
      length: Math.hypot(b.x - a.x, b.y - a.y),
      angle: Math.atan2(b.y - a.y, b.x - a.x),
    };
  }
}
