import { expandedIrregular } from "../exchange/compact_irregular.js";
import { expanded } from "../exchange/compact_surface.js";
import { summed } from "../exchange/steps.js";

/** What of a sheet is on the screen: one of its slices under one of its colours. */
export class Shown {
  #sheet;
  #scene;
  #light;
  #numbers;
  /** @type {import("../exchange/sheet.js").Shot} */
  shot;
  /** @type {import("../exchange/sheet.js").Colouring} */
  colouring;

  /**
   * @param {import("../exchange/sheet.js").Sheet} sheet
   * @param {import("../scene/scene.js").Scene} scene
   * @param {import("../lighting/baked_light.js").BakedLight} light
   */
  constructor(sheet, scene, light) {
    this.#sheet = sheet;
    this.#scene = scene;
    this.#light = light;
    this.#numbers = summed(sheet.numbers);
    [this.shot] = sheet.shots;
    [this.colouring] = sheet.colours;
    scene.setMesh(sheet.mesh);
    scene.setStatus(sheet.status);
    this.slice(0);
    scene.setOver("irregular", sheet.irregular && expandedIrregular(sheet.irregular));
    this.colour(0);
  }

  /** @param {number} place in the list of slices */
  slice(place) {
    const shot = this.#sheet.shots[place];
    const surface = expanded(shot.surface);
    this.shot = shot;
    this.#light.openness = shot.openness;
    this.#scene.setSurface(surface);
    this.#scene.setSilhouette(shot.silhouette && expanded(shot.silhouette));
    this.#scene.setOver("seeThrough", shot.see_through && expanded(shot.see_through));
    this.#scene.setOver("arrows", shot.arrows);
    this.#scene.setOver("marks", shot.marks);
    this.#scene.setOver("curves", shot.curves);
  }

  /** @param {number} place in the list of colours */
  colour(place) {
    const colouring = this.#sheet.colours[place];
    this.colouring = colouring;
    this.#scene.setStatus({ colour: colouring.colour });
    this.#scene.setCellColours(colouring.positions, colouring.high_first);
  }

  /** The camera that the page was saved with. */
  reset() {
    this.#scene.setStatus({ camera: this.#sheet.status.camera });
  }

  /** The cell under a place of the canvas, by its number in the whole mesh, and what it is coloured by. @param {number} x @param {number} y */
  cellAt(x, y) {
    const hit = this.#scene.pick(x, y);
    this.#scene.highlight(hit?.face ?? null);
    if (!hit) return null;
    const { values } = this.colouring;
    return { cell: this.#numbers[hit.cell], value: values ? values[hit.cell] : null };
  }

  /** @param {"hover" | "click"} event @param {(at: { x: number, y: number } | null) => void} hear */
  on(event, hear) {
    this.#scene.on(event, hear);
  }
}
