import { curtained } from "../figure/curtain.js";

/**
 * Which meshes a figure shows, of two that are compared: both in one, or one of them.
 *
 * @typedef {import("./side.js").Side} Side
 * @typedef {"both" | "first" | "second"} Which
 * @typedef {{ width: number, height: number, transparent: boolean }} Size  of a picture, in pixels
 */

/** The letters of the panels. */
const LETTERS = "abcdef";

/** The letters of the meshes, where their names are the same. */
const SIDES = "AB";

export class FigureSides {
  #app;

  /** @param {import("./app.js").App} app @param {Which} which */
  constructor(app, which) {
    this.#app = app;
    const { second } = app.comparing;
    /** @type {readonly Side[]} */
    this.sides = second ? { both: [app, second], first: [app], second: [second] }[which] : [app];
    /** Whether both are in one picture. */
    this.curtain = this.sides.length > 1 && app.store.status.compare.layout === "curtain";
  }

  /** Pictures of one pose. */
  get perPose() {
    return this.curtain ? 1 : this.sides.length;
  }

  /** CSS pixels that the pictures of one pose take on the screen. */
  get shown() {
    const sizes = this.sides.map(({ canvas }) => ({
      width: canvas.clientWidth,
      height: canvas.clientHeight,
    }));
    const [{ width, height }] = sizes;
    return { width: this.curtain ? width : sizes.reduce((sum, one) => sum + one.width, 0), height };
  }

  /** Tells apart figures of other meshes. */
  get key() {
    const { divider, layout } = this.#app.store.status.compare;
    const meshes = this.sides.map(({ store }) => store.status.mesh);
    return [meshes, this.curtain && divider, layout];
  }

  /** What stands below each picture: its panel's letter, the meshes' names. @param {number} panels @param {boolean} lettered @returns {string[][]} none where nothing does */
  labels(panels, lettered) {
    const named = this.sides.length > 1 && this.#app.store.status.compare.labels;
    if (!named && !lettered) return [];
    const own = this.sides.map(
      ({ facts }) => facts.get("entry")?.mesh.name ?? facts.get("summary")?.name ?? "",
    );
    const names = new Set(own).size < own.length ? own.map((name, side) => `${SIDES[side]}: ${name}`) : own;
    return Array.from({ length: panels }, (_, panel) => {
      const letter = lettered ? `${LETTERS[panel]})` : "";
      if (!named) return Array.from({ length: this.perPose }, () => [letter]);
      const words = names.map((name) => [letter, name].filter(Boolean).join(" "));
      return this.curtain ? [words] : words.map((word) => [word]);
    }).flat();
  }

  /** The pictures of the present pose. @param {Size} size @returns {Promise<Blob[]>} */
  async take(size) {
    const taken = [];
    for (const side of this.sides) {
      await side.drawing.drawn();
      taken.push(await side.scene.screenshot(size));
    }
    const [a, b] = taken;
    return this.curtain ? [await curtained(a, b, this.#app.store.status.compare.divider)] : taken;
  }
}
