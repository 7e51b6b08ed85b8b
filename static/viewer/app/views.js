import { merge } from "../state/paths.js";
import { ownView } from "../state/opening_view.js";

/** Part of the picture that cells fill which were asked for: what lies around them is seen too. */
const AMONG_OTHERS = 0.6;

/** Under this key a change of the filters and the flight to what it shows are one step of undo. */
export const FLIGHT = "flight";

/** Where the eye goes by itself: back to where it began, to what is shown, to cells that were asked for. */
export class Views {
  #app;

  /** @param {import("./side.js").Side} app */
  constructor(app) {
    this.#app = app;
    app.scene.on("blank", () => this.fitShown());
  }

  /** The settings that the open mesh has of its own. What it is compared with is none: that is told, and stays. */
  get own() {
    const { store, facts } = this.#app;
    const view = facts.get("summary")?.view;
    const { other } = store.status.compare;
    return view
      ? merge(ownView(store.defaults, view, facts.get("entry")?.mesh.view), { compare: { other } })
      : store.defaults;
  }

  /** The camera that the mesh has of its own. */
  reset() {
    const { store } = this.#app;
    store.set({ camera: this.own.camera });
  }

  /** Everything as if the mesh had been opened first. */
  async resetAll() {
    const { store, drawing } = this.#app;
    const { mesh: _, version: __, ...settings } = this.own;
    store.seal();
    store.set(settings);
    store.untouch();
    await drawing.update();
  }

  /** No filter hides anything; the slice stays ready to face the eye. */
  showAll() {
    const { store } = this.#app;
    const [plane] = this.own.filters.planes.items;
    store.set({ filters: merge(store.defaults.filters, { planes: { items: [{ ...plane, offset: 0 }] } }) });
  }

  /** Go to where all that is shown is seen, from the same side. @param {number} [filled] part of the picture that it fills @param {string} [undo] */
  fitShown(filled, undo) {
    const { store, scene } = this.#app;
    const camera = scene.cameraOnShown(filled);
    if (!camera) return;
    store.set({ camera }, undo === undefined ? {} : { undo });
  }

  /** Go to the cells that a change of the filters leaves, when they have come; one step of undo with that change. */
  async flyToShown() {
    const { store, drawing } = this.#app;
    const { filters } = store.status;
    await drawing.update();
    if (store.status.filters === filters) this.fitShown(AMONG_OTHERS, FLIGHT);
    store.seal();
  }
}
