import {
  ColorManagement,
  Group,
  LinearSRGBColorSpace,
  RGBAFormat,
  Scene,
  UnsignedByteType,
  Vector4,
  WebGLRenderTarget,
  WebGLRenderer,
} from "three";
import { componentsOf } from "../../colours/components.js";
import { copy } from "./copy.js";

ColorManagement.enabled = false;

/** Thrown where the browser has no WebGL 2 to give. */
export class WebGLMissing extends Error {
  name = "WebGLMissing";
}

/** Side of a draft's pixels in those of the canvas. */
const COARSE = 2;

/**
 * Owns the WebGL renderer and the order of the layers: backdrop (silhouette, never over the model), model, ink (lines and
 * irregular edges), overlay (plane, highlight), veil (what the model is seen through). They are drawn in that order in one go, so that a target of several samples
 * is resolved once; three keeps an order only among what it calls transparent, so all that is in them does.
 *
 * The canvas shows whole pictures, smoothed by four samples, or drafts of larger pixels and one sample, for GPUs that are too
 * slow to draw a whole one for every move.
 */
export class Painter {
  backdrop = new Group();
  model = new Group();
  ink = new Group();
  overlay = new Group();
  veil = new Group();
  renderer;
  #scene = new Scene();
  #before = [this.model, this.ink, this.overlay, this.veil];
  /** @type {WebGLRenderTarget | null} */
  #whole = null;
  /** The backdrop of the drafts, for as long as neither it nor the camera changes. @type {WebGLRenderTarget | null} */
  #behind = null;
  #behindOf = "";
  #backdropVersion = 0;
  /** @type {WebGLRenderTarget | null} */
  #draft = null;
  #size = { width: 1, height: 1 };
  #small = false;
  /** @type {[number, number, number]} */
  #background = [1, 1, 1];

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    const attributes = {
      alpha: false,
      depth: true,
      stencil: false,
      antialias: false, // whole pictures have their own target
      preserveDrawingBuffer: false,
      powerPreference: /** @type {const} */ ("high-performance"),
    };
    const context = /** @type {WebGL2RenderingContext | null} */ (canvas.getContext("webgl2", attributes));
    if (!context) throw new WebGLMissing("This browser offers no WebGL 2, which the drawing needs");
    this.renderer = new WebGLRenderer({ canvas, context, ...attributes });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.autoClear = false;
    this.renderer.sortObjects = false;
    this.renderer.info.autoReset = false;
    this.renderer.debug.checkShaderErrors = false;
    this.#scene.add(this.backdrop, ...this.#before);
    this.#scene.matrixWorldAutoUpdate = false;
  }

  /** @returns {WebGL2RenderingContext} */
  get gl() {
    return /** @type {WebGL2RenderingContext} */ (this.renderer.getContext());
  }

  /** @param {string} colour */
  set background(colour) {
    this.#background = componentsOf(colour);
  }

  /** Pixels of a picture on the canvas: fewer for a draft. @param {boolean} draft */
  pixels(draft) {
    const { width, height } = this.#size;
    if (!draft) return { width, height };
    return { width: Math.ceil(width / COARSE), height: Math.ceil(height / COARSE) };
  }

  /** Pixels of the canvas at this moment. */
  get canvas() {
    return this.pixels(this.#small);
  }

  /**
   * Draws a picture onto the canvas.
   *
   * @param {import("three").Camera} camera
   * @param {boolean} draft
   * @param {{ many?: boolean, bare?: boolean }} [options] many: more drafts will follow: then the canvas itself becomes small, which
   *   takes longer than a draft but makes each faster; bare: the model alone
   */
  show(camera, draft, { many = false, bare = false } = {}) {
    if ((draft && many) !== this.#small) {
      this.#small = draft && many;
      this.#fit();
    }
    if (bare) return this.#paintBare(camera);
    if (draft) return this.#paintDraft(camera);
    this.#whole ??= new WebGLRenderTarget(this.#size.width, this.#size.height, {
      format: RGBAFormat,
      type: UnsignedByteType,
      samples: 4,
      generateMipmaps: false,
    });
    this.paint(camera, this.#whole);
    copy(this.renderer, this.#whole, null, this.#size);
  }

  /** What is in the backdrop, or how it looks, has changed. */
  renewBackdrop() {
    this.#backdropVersion++;
  }

  /** @param {import("three").Camera} camera */
  #paintBare(camera) {
    const others = [this.backdrop, this.ink, this.overlay, this.veil];
    this.#begin(null);
    for (const part of others) part.visible = false;
    this.renderer.render(this.#scene, camera);
    for (const part of others) part.visible = true;
  }

  /** @param {import("three").Camera} camera */
  #paintDraft(camera) {
    const size = this.pixels(true);
    const target = () => new WebGLRenderTarget(size.width, size.height, { generateMipmaps: false });
    this.#behind ??= target();
    if (!this.#small) this.#draft ??= target();
    const onto = this.#small ? null : this.#draft;
    const view = [...camera.matrixWorld.elements, ...camera.projectionMatrix.elements];
    const wanted = [this.#backdropVersion, ...this.#background, ...view].join();
    if (wanted !== this.#behindOf) {
      this.#behindOf = wanted;
      this.#begin(this.#behind);
      for (const part of this.#before) part.visible = false;
      this.renderer.render(this.#scene, camera);
      for (const part of this.#before) part.visible = true;
    }
    this.#begin(onto);
    copy(this.renderer, this.#behind, onto, size);
    this.backdrop.visible = false;
    this.renderer.render(this.#scene, camera);
    this.backdrop.visible = true;
    if (onto) copy(this.renderer, onto, null, this.#size);
  }

  /**
   * Draws all layers into a target, or onto the canvas.
   *
   * @param {import("three").Camera} camera
   * @param {WebGLRenderTarget | null} target
   * @param {{ background?: string | null, overlay?: boolean }} [options] background: another than its own
   */
  paint(camera, target, { background = null, overlay = true } = {}) {
    this.#begin(target, background ? componentsOf(background) : this.#background);
    this.overlay.visible = overlay;
    this.renderer.render(this.#scene, camera);
  }

  /** @param {WebGLRenderTarget | null} target @param {[number, number, number]} [background] */
  #begin(target, [r, g, b] = this.#background) {
    const { renderer } = this;
    renderer.info.reset();
    renderer.setRenderTarget(target);
    renderer.setScissorTest(false);
    renderer.state.buffers.color.setMask(true);
    renderer.state.buffers.depth.setMask(true);
    renderer.state.buffers.color.setClear(r, g, b, 1, false);
    this.gl.clear(this.gl.COLOR_BUFFER_BIT | this.gl.DEPTH_BUFFER_BIT);
  }

  /**
   * Draws into a corner of the canvas, after the picture.
   *
   * @param {(renderer: WebGLRenderer) => void} draw
   */
  corner(draw) {
    const viewport = this.renderer.getViewport(new Vector4());
    draw(this.renderer);
    this.renderer.setViewport(viewport);
  }

  /** @param {number} width device pixels @param {number} height */
  resize(width, height) {
    this.#size = { width, height };
    this.forget();
    this.#fit();
  }

  #fit() {
    const { width, height } = this.canvas;
    this.renderer.setSize(width, height, false);
    this.renderer.setViewport(new Vector4(0, 0, width, height));
  }

  /** Gives up its targets, to make new ones when next asked. */
  forget() {
    for (const target of [this.#whole, this.#behind, this.#draft]) target?.dispose();
    this.#whole = this.#behind = this.#draft = null;
    this.#behindOf = "";
  }

  dispose() {
    this.forget();
    this.renderer.dispose();
    this.renderer.forceContextLoss(); // a browser holds but some 16 contexts, then takes the oldest from whoever has it
  }
}
