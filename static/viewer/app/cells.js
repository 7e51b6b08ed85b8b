import { Superseded } from "../core/client.js";
import { decimal } from "../state/numbers.js";
import { cameraOnCell } from "../state/camera.js";
import { planesOf, withPlane } from "../state/planes.js";
import { quantityOf } from "../state/quantity.js";
import { dig, isolate, undig } from "../state/picking.js";
import { FLIGHT } from "./views.js";

/** @typedef {import("../state/facts.js").PickingTool} PickingTool */

/** What can be done to single cells: inspect, fly to, pick, show those of a finding. */
export class Cells {
  #app;
  #asked = 0;

  /** @param {import("./side.js").Side} app */
  constructor(app) {
    this.#app = app;
    for (const path of ["structure.explode", "structure.kind", "structure.form"])
      app.store.on(path, () => void this.#mark());
  }

  /** Outlines the inspected cell where it stands now: its block may be drawn elsewhere than before. */
  async #mark() {
    const { client, facts, scene } = this.#app;
    const cell = facts.get("cell")?.cell;
    if (cell === undefined) return;
    try {
      const { edges } = await client.call("cell_view", [cell], { replace: "mark" });
      if (facts.get("cell")?.cell === cell) scene.mark(edges);
    } catch {
      // a newer place is asked for, or the mesh went: there is nothing to outline
    }
  }

  /** Show a cell in the inspector, or close it. @param {number | null} cell */
  async inspect(cell) {
    const { facts, client, messages, scene } = this.#app;
    const asked = ++this.#asked;
    if (cell === null) {
      scene.highlight(null);
      scene.mark(null);
      return facts.set({ cell: null, flown: false });
    }
    try {
      const look = async () => {
        const found = await client.call("inspect", [cell], { replace: "inspect" });
        if (asked === this.#asked) facts.set({ cell: found });
        return found;
      };
      const { pending } = await look();
      const view = await client.call("cell_view", [cell]);
      if (asked !== this.#asked) return;
      scene.mark(view.edges);
      this.#app.messages.settle("inspect");
      if (!pending.length) return;
      await this.#measureSizes();
      if (asked === this.#asked) await look();
    } catch (error) {
      if (asked === this.#asked && !(error instanceof Superseded))
        messages.error(error, { topic: "inspect" });
    }
  }

  /** Has the core measure what sizes are compared with: a share of the cells at a time, so that a slice can come between. */
  async #measureSizes() {
    const { client, facts } = this.#app;
    const summary = facts.get("summary");
    while (facts.get("summary") === summary && !(await client.call("measure_sizes")));
  }

  /** Tell the value of the cell under the pointer, in the metric or attribute looked at. @param {number} cell */
  async tell(cell) {
    const { client, facts } = this.#app;
    const { id, name, symbol, unit } = quantityOf(this.#app);
    const ask = () => client.call("value", [cell, id], { replace: "hover" });
    const here = () => facts.get("hover")?.cell === cell;
    try {
      let found = await ask();
      if (found.pending && here()) {
        await this.#measureSizes();
        if (here()) found = await ask();
      }
      const { kind, value, components, structure } = found;
      if (here())
        facts.set({ hover: { cell, kind, name: symbol || name, value, unit, components, structure } });
    } catch {
      // the pointer went on, or another mesh has come: nothing to tell
    }
  }

  /** Bring a cell before the camera, beside the inspector, and inspect it. @param {number} cell */
  async flyTo(cell) {
    const { client, store, messages, facts } = this.#app;
    try {
      const view = await client.call("cell_view", [cell]);
      store.set({ camera: cameraOnCell(store.status.camera, view) }, { undo: "fly" });
      await this.inspect(cell);
      facts.set({ flown: true });
    } catch (error) {
      messages.error(error, { topic: "inspect" });
    }
  }

  /**
   * Go to a cell or a vertex by the number that the file gives it: it is isolated with what lies around it, but for cells that
   * would hide it from the eye, and flown to; one step of undo leads back.
   *
   * @param {"cell" | "vertex"} kind @param {number} number @returns {Promise<boolean>} whether one is there
   */
  async goTo(kind, number) {
    const { client, store, messages, views } = this.#app;
    try {
      const found = await client.call("find", [kind, number, store.status.camera.direction]);
      messages.settle("go");
      store.seal();
      if (found.around.length) store.set({ filters: { picking: isolate(found.around) } }, { undo: FLIGHT });
      if (found.cell >= 0) await this.inspect(found.cell);
      if (found.around.length) await views.flyToShown();
      const { length } = found.rows;
      const note = (/** @type {string} */ text) => messages.say("note", text, { topic: "go" });
      if (length > 1)
        note(
          `${length} ${kind === "cell" ? "elements" : "nodes"} have the number ${number}: this is the first`,
        );
      else if (found.cell < 0)
        note(
          `No element has node ${number}: it lies at ${found.place.map((one) => decimal(one)).join(", ")}`,
        );
      return found.around.length > 0;
    } catch (error) {
      if (!(error instanceof Superseded)) messages.error(error, { topic: "go" });
      return false;
    }
  }

  /** Cells as a text for other programs; null if that failed. @param {readonly number[]} cells rows @param {string} form @param {string} name */
  async list(cells, form, name) {
    try {
      return await this.#app.client.call("cell_list", [cells, form, name]);
    } catch (error) {
      this.#app.messages.error(error, { topic: "list" });
      return null;
    }
  }

  /** Put the plane at hand through a cell, so that the cut faces the eye. @param {number} cell */
  async cutTo(cell) {
    const { client, store, messages } = this.#app;
    const { planes, index } = planesOf(this.#app);
    const { rule } = store.status.filters.planes;
    const { direction } = store.status.camera;
    try {
      const offset = await client.call("cut_to", [cell, direction, rule]);
      const cut = { enabled: true, normal: direction, offset };
      const items = planes.length ? withPlane(planes, index, cut) : [cut];
      store.seal();
      store.set({ filters: { planes: { enabled: true, items } } });
    } catch (error) {
      messages.error(error, { topic: "inspect" });
    }
  }

  /** @param {PickingTool} action @param {number} cell */
  pick(action, cell) {
    const { store } = this.#app;
    const { picking } = store.status.filters;
    const next = {
      dig,
      undig,
      isolate: (/** @type {unknown} */ _, /** @type {number} */ one) => isolate([one]),
    }[action](picking, cell);
    store.seal();
    store.set({ filters: { picking: next } }, { undo: FLIGHT });
    if (action === "isolate") void this.#app.views.flyToShown();
  }

  /** What a click on a face does. @param {import("../state/facts.js").Tool} tool @param {{ face: number, cell: number }} hit */
  async act(tool, hit) {
    const { client, facts, messages } = this.#app;
    if (tool === "undig") {
      try {
        const behind = await client.call("neighbour", [hit.face]);
        if (behind >= 0) this.pick("undig", behind);
      } catch (error) {
        messages.error(error, { topic: "pick" });
      }
      return;
    }
    if (tool === "dig" || tool === "isolate") this.pick(tool, hit.cell);
    else void this.inspect(hit.cell);
    if (tool === "isolate") facts.set({ tool: "turn" });
  }

  /** Isolate the cells of a finding. @param {{ id: string, message: string }} finding */
  async showFinding(finding) {
    const { client, store, messages } = this.#app;
    try {
      const cells = await client.call("finding_cells", [finding.id]);
      if (!cells.length)
        return messages.say("note", `${finding.message}: no cells to show`, { topic: "finding" });
      store.seal();
      messages.settle("finding");
      store.set({ filters: { picking: isolate(cells) } }, { undo: FLIGHT });
      await this.#app.views.flyToShown();
    } catch (error) {
      messages.error(error, { topic: "finding" });
    }
  }
}
