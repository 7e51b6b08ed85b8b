import { ENOUGH, ObjectSpaceAO } from "./object_space_ao.js";
import { ScreenSpaceAO } from "./screen_space_ao.js";
import { TimeBudget } from "./time_budget.js";

/** Directions at which nothing is left of the screen-space term. */
const FADED = 48;

/** Directions before the first picture of a surface, and in a lot that fills the depth maps. */
const FIRST = 8;
const BATCH = 16;

/** Lots from which on the GPU counts as fast: the screen-space term is drawn besides, to smooth the first directions. */
const FAST = 32;

/** A new picture is worth drawing when the number of directions has grown by this; on a slow GPU, where it costs much light. */
const GROWTH = 3;
const GROWTH_SLOW = 8;

/**
 * @typedef {"none" | "direct" | "screen_space_ao" | "object_space_ao"} LightingMode
 *
 * @typedef {object} LitLayer the surface as it is drawn, to be lit
 * @property {import("../geometry/records.js").Surface | null} surface
 * @property {{ geometry: import("three").BufferGeometry }} mesh
 * @property {number} edge mean side of a face
 * @property {LightingMode} lighting
 * @property {(share: number, texture: import("three").Texture | null) => void} setOcclusion
 * @property {LitUniforms} uniforms
 *
 * @typedef {object} LightingLike  what the scene knows of its light
 * @property {LightingMode} mode
 * @property {readonly import("three").Material[]} materials
 * @property {boolean} settled
 * @property {number} elapsed
 * @property {() => void} restart
 * @property {() => void} forget
 * @property {(busy: boolean, slow: boolean) => { again: boolean, draw: boolean }} step
 * @property {() => Promise<void>} complete
 * @property {() => Promise<Float32Array>} baked
 * @property {Lighting["prepare"]} prepare
 * @property {() => void} dispose
 *
 * @typedef {(renderer: import("three").WebGLRenderer, layer: LitLayer) => LightingLike} MakeLighting
 *
 * @typedef {object} LitUniforms
 * @property {{ value: number }} screenShare of the screen-space term in the light
 * @property {{ value: import("three").Texture }} screenOpenness
 * @property {{ value: import("three").Vector2 }} screenScale
 */

/**
 * Chooses and feeds the light of the surface: which terms are gathered, when, and how they are mixed in its shader.
 *
 * @implements {LightingLike}
 */
export class Lighting {
  object;
  /** @type {LightingMode} */
  mode = "object_space_ao";
  #screen;
  #budget;
  #layer;
  #nextPicture = 0;
  #began = 0;
  /** Whether the screen-space term of the present view covers for the other. */
  #covering = false;
  #view = "";

  /**
   * @param {import("three").WebGLRenderer} renderer
   * @param {LitLayer} layer
   * @param {number} [most] directions from which light is gathered
   */
  constructor(renderer, layer, most) {
    this.object = new ObjectSpaceAO(renderer, most);
    this.#screen = new ScreenSpaceAO(renderer);
    this.#budget = new TimeBudget(/** @type {WebGL2RenderingContext} */ (renderer.getContext()), 64);
    this.#layer = layer;
  }

  /** By which light is gathered. */
  get materials() {
    return [...this.object.materials, ...this.#screen.materials];
  }

  /** Whether the picture is as good as it will be. */
  get settled() {
    return this.mode !== "object_space_ao" || this.object.done;
  }

  /** The surface's geometry has changed. */
  restart() {
    this.object.setSurface(this.#layer.surface, this.#layer.mesh.geometry);
    this.#nextPicture = 0;
    this.#covering = false;
    this.#view = "";
    this.#began = performance.now();
  }

  /** The context is lost: drops what lay in it, while that can still be said without error, to begin anew in the next. */
  forget() {
    this.object.forget();
    this.#screen.forget();
    this.#budget.reset();
    this.restart();
  }

  /**
   * One turn of gathering.
   *
   * @param {boolean} busy the user holds something: smaller lots
   * @param {boolean} slow whether the GPU takes long for a picture
   * @returns {{ again: boolean, draw: boolean }}
   */
  step(busy, slow) {
    const { object } = this;
    if (this.settled) return { again: false, draw: false };
    const fresh = object.count === 0;
    if (fresh || this.#budget.ready(busy)) {
      // The first picture shall have its light; lots below a batch waste more than they give.
      const wanted = fresh ? FIRST : Math.max(busy ? 2 : BATCH, this.#budget.size);
      for (let left = wanted; left > 0 && !object.done; ) {
        const done = object.advance(left);
        left -= done;
      }
      this.#budget.given(wanted);
    }
    const draw = object.count >= this.#nextPicture || object.done;
    if (draw) this.#nextPicture = Math.max(ENOUGH, object.count * (slow ? GROWTH_SLOW : GROWTH));
    return { again: !object.done, draw };
  }

  /** Gathers what is left, giving way to the page in between. @returns {Promise<void>} */
  async complete() {
    while (!this.settled) {
      this.object.advance(16);
      if (this.object.count % 64 === 0) await new Promise((resolve) => setTimeout(resolve));
    }
  }

  /** How open each drawn vertex is to light, 0 to 1, gathered from all directions whatever the mode. @returns {Promise<Float32Array>} */
  async baked() {
    const { object } = this;
    while (!object.done) {
      object.advance(BATCH);
      if (object.count % 64 === 0) await new Promise((resolve) => setTimeout(resolve));
    }
    return object.empty ? new Float32Array(0) : object.read();
  }

  /** Milliseconds from the surface's change to now. */
  get elapsed() {
    return performance.now() - this.#began;
  }

  /**
   * Sets the surface's shader for the next picture, and draws the screen-space term where it is used.
   *
   * @param {import("three").PerspectiveCamera | import("three").OrthographicCamera} camera
   * @param {{ width: number, height: number, perUnit: number, draft: boolean }} view draft: no screen-space term, which would
   *   take longer than all else; a head light stands in until the other is there
   */
  prepare(camera, { width, height, perUnit, draft }) {
    const { object, mode } = this;
    const uniforms = this.#layer.uniforms;
    this.#layer.lighting = mode;
    if (draft) return this.#prepareDraft();
    let share = mode === "object_space_ao" && object.count >= ENOUGH ? 1 : 0;
    let cover = mode === "screen_space_ao" ? 1 : 0;
    if (mode === "object_space_ao" && object.count < FADED && this.#layer.surface) {
      const now = [...camera.matrixWorld.elements, ...camera.projectionMatrix.elements, width, height].join();
      // Once the true term stands alone in a view that moves, the estimate does not come back.
      if (share > 0 && now !== this.#view) this.#covering = false;
      if (share === 0 || (object.count <= FIRST && this.#budget.size >= FAST)) this.#covering = true;
      if (this.#covering) {
        cover = 1;
        const fade = (object.count - ENOUGH) / (FADED - ENOUGH);
        share = share > 0 ? Math.max(0.25, fade) : 0;
      }
      if (this.#covering && now !== this.#view) this.#drawScreen(camera, width, height, perUnit);
      this.#view = now;
    }
    if (mode === "screen_space_ao") this.#drawScreen(camera, width, height, perUnit);
    this.#layer.setOcclusion(share, share > 0 ? object.texture : null);
    uniforms.screenShare.value = cover;
    if (cover > 0 && this.#screen.texture) uniforms.screenOpenness.value = this.#screen.texture;
    uniforms.screenScale.value.set(1 / width, 1 / height);
  }

  #prepareDraft() {
    const { object, mode } = this;
    const gathered = mode === "object_space_ao" && object.count >= ENOUGH;
    if (mode !== "none" && !gathered) this.#layer.lighting = "direct";
    this.#layer.setOcclusion(gathered ? 1 : 0, gathered ? object.texture : null);
    this.#layer.uniforms.screenShare.value = 0;
    this.#view = "";
  }

  /**
   * @param {import("three").PerspectiveCamera | import("three").OrthographicCamera} camera
   * @param {number} width
   * @param {number} height
   * @param {number} perUnit
   */
  #drawScreen(camera, width, height, perUnit) {
    const { mesh, edge } = this.#layer;
    this.#screen.draw(mesh.geometry, camera, { width, height, edge, perUnit });
  }

  dispose() {
    this.object.dispose();
    this.#screen.dispose();
    this.#budget.reset();
  }
}
