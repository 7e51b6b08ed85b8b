import { Superseded } from "../core/client.js";
import { CoreSettings } from "../state/core_settings.js";
import { toldOf } from "../state/arrows.js";
import { normalised } from "../state/vectors.js";

/**
 * @typedef {import("../state/answers.js").Update} Update
 * @typedef {import("../state/status.js").PartialStatus} PartialStatus
 *
 * @typedef {Partial<Update> & Pick<Update, "shown_cells" | "shown_faces">} Answer  of the core, or a preview
 * @typedef {Pick<Update, "surface" | "silhouette" | "see_through" | "irregular" | "arrows" | "marks" | "curves" | "reference">} Records
 */

/**
 * Status to core to scene: every change goes to the scene at once, and to the core what of it concerns the core, whose
 * records go to the scene when they come. A newer change replaces one that still waits.
 */
export class Drawing {
  #look;
  #client;
  #scene;
  #facts;
  #messages;
  #settings;
  #ready = false;
  /** Whether the surface that is there, or was asked for last, lacks edges and silhouette. */
  #lean = false;
  /** Whether an answer, or a part of it, has not come to the screen: then every record is asked for. */
  #lost = false;
  /** @type {Promise<void>} */
  #latest = Promise.resolve();
  /** @type {Partial<Records>} */
  #records = {};

  /** @param {Pick<import("./side.js").Side, "look" | "client" | "scene" | "facts" | "messages" | "tables">} side */
  constructor({ look, client, scene, facts, messages, tables }) {
    this.#look = look;
    this.#client = client;
    this.#scene = scene;
    this.#facts = facts;
    this.#messages = messages;
    this.#settings = new CoreSettings(tables.core_paths);
    scene.setStatus(look.status);
    look.on("*", (status, changed) => {
      scene.setStatus(status);
      // The translucent plane moves with the answer: a picture of it alone would delay that of the slice.
      if (this.#settings.concern(changed)) void this.update();
      else if (this.#facts.get("planeShown")) this.#showPlane();
    });
    facts.on("planeShown", () => this.#showPlane());
    scene.on("calm", () => {
      if (this.#ready && this.#lean) this.#latest = this.#ask(true);
    });
    facts.on("statistics", (statistics) => {
      const { min, not_finite } = statistics.scaled_jacobian ?? { min: null };
      scene.outward = min !== null && min > 0 && not_finite === 0;
    });
  }

  /** What is on the screen: of each kind the record that came last for the open mesh. */
  get records() {
    return this.#records;
  }

  /** The core holds the mesh on the screen. */
  begin() {
    this.#records = {};
    this.#settings.forget();
    this.#ready = true;
  }

  /** The core holds no mesh, or another. */
  pause() {
    this.#ready = false;
  }

  /** Ask the core for what the present status shows. @returns {Promise<void>} */
  update() {
    if (this.#ready) this.#latest = this.#ask();
    return this.#latest;
  }

  /** Resolves when nothing is asked for any more and the picture of it has been drawn. */
  async drawn() {
    /** @type {Promise<void> | null} */
    let last = null;
    while (last !== this.#latest) {
      last = this.#latest;
      await last;
    }
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
  }

  /** Show a surface that was prepared at build time, before the core runs. @param {import("../state/answers.js").Preview} preview */
  show(preview) {
    this.#take(preview);
  }

  /** @param {boolean} [same] nothing has moved: what a lean answer left out is wanted */
  async #ask(same = false) {
    try {
      const lean = !same && this.#scene.hurried;
      this.#lean = lean;
      // What has changed is found when the call is sent: one that another replaces takes no change with it.
      const args = () =>
        /** @type {[PartialStatus, boolean, boolean]} */ ([
          this.#settings.changed(this.#look.status),
          lean,
          this.#lost,
        ]);
      const answer = await this.#client.call("update", args, { replace: "update" });
      this.#take(answer, same);
      this.#lost = false;
      this.#messages.settle("update");
      const slice = this.#client.milliseconds.update;
      const timings = { ...this.#facts.get("timings"), ...answer.timings, slice };
      this.#facts.set({ timings });
    } catch (error) {
      if (error instanceof Superseded) return;
      this.#settings.forget();
      this.#lost = true;
      this.#messages.error(error, { topic: "update" });
    }
  }

  /** @param {Answer} answer @param {boolean} [same] the surface is the one on the screen, with its edges */
  #take(answer, same = false) {
    const scene = this.#scene;
    const began = performance.now();
    const { surface, silhouette, see_through, irregular, arrows, marks, curves, reference } = answer;
    const came = { surface, silhouette, see_through, irregular, arrows, marks, curves, reference };
    for (const [kind, record] of Object.entries(came))
      if (record) this.#records = { ...this.#records, [kind]: record };
    if (answer.surface) scene.setSurface(answer.surface, same);
    if (answer.silhouette) scene.setSilhouette(answer.silhouette);
    if (answer.see_through) scene.setOver("seeThrough", answer.see_through);
    if (answer.irregular) scene.setOver("irregular", answer.irregular);
    if (answer.arrows) scene.setOver("arrows", answer.arrows);
    if (answer.marks) scene.setOver("marks", answer.marks);
    if (answer.curves) scene.setOver("curves", answer.curves);
    if (answer.reference) scene.setOver("reference", answer.reference);
    if (answer.colour !== undefined)
      scene.setCellColours(answer.colour?.map_position ?? null, answer.colour?.high_first ?? false);
    const upload = performance.now() - began;
    this.#facts.set({
      shown: { cells: answer.shown_cells, faces: answer.shown_faces },
      ...(answer.colour !== undefined ? { colour: answer.colour } : {}),
      ...(answer.irregular ? { irregular: answer.irregular.counts } : {}),
      ...(answer.arrows ? { arrows: toldOf(answer.arrows) } : {}),
      ...(answer.marks ? { marks: answer.marks.counts } : {}),
      ...(answer.max_depth !== undefined && answer.max_depth !== null
        ? { layers: answer.max_depth + 1 }
        : {}),
      ...(answer.plane_ranges ? { planeRanges: answer.plane_ranges } : {}),
      timings: { ...this.#facts.get("timings"), upload },
    });
    if (this.#facts.get("planeShown")) this.#showPlane();
    scene.flush();
  }

  /** The translucent plane, while its slider is held. */
  #showPlane() {
    const { items } = this.#look.status.filters.planes;
    const index = this.#facts.get("plane");
    const plane = items[Math.min(index, items.length - 1)];
    if (!plane || !this.#facts.get("planeShown")) return this.#scene.showPlane(null);
    const extent = this.#facts.get("planeRanges")[index] ?? undefined;
    this.#scene.showPlane({ normal: normalised(plane.normal), offset: plane.offset, extent });
  }
}
