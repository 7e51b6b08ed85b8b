import { Vector3 } from "three";
import { release } from "../layers/release.js";
import { Picker } from "./picker.js";

/**
 * What stands under a place of the canvas, and what follows from it: the face picked, the centre to turn about.
 */
export class Pointing {
  #view;
  #painter;
  #picker;

  /** @param {import("../frame/view.js").View} view @param {import("../frame/painter.js").Painter} painter */
  constructor(view, painter) {
    this.#view = view;
    this.#painter = painter;
    this.#picker = new Picker(painter.renderer);
  }

  /** @param {import("../../geometry/records.js").Surface | null} surface */
  set(surface) {
    this.#picker.set(surface);
  }

  /**
   * The face under a place of the canvas.
   *
   * @param {number} x CSS pixels from the canvas's left
   * @param {number} y from its top
   * @returns {import("../scene_like.js").FaceHit | null}
   */
  pick(x, y) {
    const row = this.#rowAt(x, y);
    const { surface } = this.#picker;
    if (row < 0 || !surface) return null;
    const face = surface.faces[row];
    return { face, cell: face >>> 3, localFace: face & 7 };
  }

  /**
   * Makes the point of the model under a place the centre that the view turns about.
   *
   * @param {number} x
   * @param {number} y
   * @returns {boolean} whether there is one
   */
  centre(x, y) {
    const row = this.#rowAt(x, y);
    if (row < 0) return false;
    const { rig, size } = this.#view;
    const ray = rig.rayAt((2 * x) / size.width - 1, 1 - (2 * y) / size.height);
    const place = this.#picker.meet(row, ray);
    if (!place) return false;
    rig.release();
    const forward = new Vector3(0, 0, -1).applyQuaternion(rig.orientation);
    if (rig.projection === "perspective") {
      rig.distance = Math.max(1e-4, place.clone().sub(ray.origin).dot(forward));
    }
    rig.target.copy(place);
    return true;
  }

  /** @param {number} x @param {number} y @returns {number} row of the face, -1 for none */
  #rowAt(x, y) {
    if (this.#painter.gl.isContextLost()) return -1;
    this.#view.aim();
    const { width, height } = this.#painter.pixels(false);
    const scale = width / this.#view.size.width;
    return this.#picker.rowAt(this.#view.rig.camera, x * scale, y * scale, width, height);
  }

  /** The context is lost: gives up what lay in it. */
  forget() {
    release(this.#picker.scene);
  }

  dispose() {
    this.#picker.dispose();
  }
}
