import { boxOf, cornersOf } from "../geometry/box.js";
import { areAlike, areNear, frameOfBox, placeIn, pointsIn } from "../state/frames.js";
import { idsOfGroups } from "../state/groups.js";
import { asFarAsKnown, withReach } from "../state/known_quantities.js";
import { hasAttribute } from "../state/opening_view.js";
import { quantityOf } from "../state/quantity.js";
import { comparedOf, tracedOf } from "../state/tables.js";

/** The file's own coordinates. */
const WHOLE = { centre: [0, 0, 0], diagonal: 1 };

/**
 * How two meshes are seen under one status: what of it each has, whether both stand at the same place, the range of their
 * colours.
 *
 * @typedef {import("./comparing.js").Second} Second
 */

export class SeenTogether {
  #app;
  /** @type {Second | null} */
  #second = null;
  /** The range of the values of both, where colours are common to them. @type {[number, number] | null} */
  #common = null;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
    const { store, facts, look } = app;
    look.derive((status) => withReach(asFarAsKnown(status, this.#known), this.#common));
    facts.on("comparison", (told) => {
      const stale = this.#forget();
      look.renew();
      this.#know();
      if (told) for (const { measures } of stale) void measures.measured();
      this.#place();
    });
    facts.on("summary", () => this.#place());
    facts.on("statistics", () => this.#reach());
    store.on("colour", () => this.#reach());
    store.on("compare.colours", () => this.#reach());
    store.on("compare.camera", () => this.#place());
  }

  /** @param {Second} second */
  begin(second) {
    this.#second = second;
    for (const name of /** @type {const} */ (["summary", "description"]))
      second.facts.on(name, () => this.#know());
    second.facts.on("statistics", () => this.#reach());
  }

  end() {
    this.#second = null;
    this.#common = null;
    this.#app.scene.setBeside(null);
    this.#app.facts.set({ together: false });
    this.#app.look.renew();
  }

  /** What is known of quantities of a comparison is of the one before. @returns {import("./side.js").Side[]} those of which something was known */
  #forget() {
    const of = (/** @type {string | undefined} */ id) =>
      id !== undefined && comparedOf(this.#app.tables, id) !== undefined;
    return [this.#app, ...(this.#second ? [this.#second] : [])].filter(({ facts }) => {
      const known = Object.entries(facts.get("statistics"));
      const kept = known.filter(([id]) => !of(id));
      const stale = {
        ...(kept.length < known.length ? { statistics: Object.fromEntries(kept) } : {}),
        ...(of(facts.get("histogram")?.quantity) ? { histogram: null } : {}),
        ...(of(facts.get("worst")?.quantity) ? { worst: null } : {}),
      };
      facts.set(stale);
      return Object.keys(stale).length > 0;
    });
  }

  /** What of the status the second mesh has. */
  #know() {
    const second = this.#second;
    const summary = second?.facts.get("summary");
    if (!second || !summary) return;
    const groups = idsOfGroups(second.facts);
    const { tables, facts } = this.#app;
    second.store.know({
      same: facts.get("comparison")?.same_cells ?? false,
      cells: summary.cells,
      has: (quantity, components) =>
        comparedOf(tables, quantity)
          ? this.#known(quantity)
          : tracedOf(tables, quantity) !== undefined || hasAttribute(summary, quantity, components),
      groups: (id) => groups.has(id),
    });
    this.#place();
    this.#reach();
  }

  /** Whether a mesh has a quantity, as far as the comparison decides on that. @param {string} quantity */
  #known = (quantity) => {
    const row = comparedOf(this.#app.tables, quantity);
    const told = this.#app.facts.get("comparison");
    return !row || (told !== null && (told.same_cells || !row.cellwise));
  };

  /** Whether both are seen at the same place, and by which frames; a reference surface is, if that leaves the mesh to be seen. */
  #place() {
    const second = this.#second;
    const [a, b] = [this.#app.facts.get("summary"), second?.facts.get("summary")];
    if (!second) return this.#placeSurface();
    if (!a || !b) return;
    const { camera } = this.#app.store.status.compare;
    const together = camera === "same" || (camera === "auto" && areAlike(a, b));
    const [first, other] = [a, b].map(({ outline }) => outline ?? new Float32Array(0));
    this.#app.scene.setBeside(together ? pointsIn(other, b, a) : null);
    second.scene.setBeside(together ? pointsIn(first, a, b) : null);
    second.store.know({ frames: together ? { first: a, second: b } : null });
    this.#app.facts.set({ together });
  }

  #placeSurface() {
    const { facts, scene, store } = this.#app;
    const summary = facts.get("summary");
    const extent = facts.get("comparison")?.surface?.extent;
    const { camera } = store.status.compare;
    if (!summary) return;
    const together =
      extent &&
      (camera === "same" || (camera === "auto" && areNear(summary, frameOfBox(extent)))) &&
      boxOf(Float32Array.from(extent.flatMap((end) => placeIn(end, WHOLE, summary))));
    scene.setBeside(together ? Float32Array.from(cornersOf(together)) : null);
  }

  /** The range of the values of both, where colours are common to them. */
  #reach() {
    const second = this.#second;
    if (!second) return;
    const { colours } = this.#app.store.status.compare;
    const { id } = quantityOf(this.#app);
    const known = [this.#app, second].map(({ facts }) => facts.get("statistics")[id]);
    const ends = known.flatMap((one) => [one?.min, one?.max]).filter((end) => typeof end === "number");
    this.#common = colours === "common" && ends.length === 4 ? [Math.min(...ends), Math.max(...ends)] : null;
    this.#app.look.renew();
    second.store.know({ reach: this.#common });
  }
}
