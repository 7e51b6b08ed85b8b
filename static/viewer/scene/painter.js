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
import { componentsOf } from "./colour.js";
import { Copier } from "./copier.js";

ColorManagement.enabled = false;

/** Thrown where the browser has no WebGL 2 to give. */
export class WebGLMissing extends Error {
  name = "WebGLMissing";
}

/** Side of a draft's pixels in those of the canvas. */
const COARSE = 2;

/**
 * Owns the WebGL renderer and the order of the layers: backdrop (silhouette, never over the model), model, ink (lines and
 * irregular edges), overlay (plane, highlight). They are drawn in that order in one go, so that a target of several samples
 * is resolved once; three keeps an order only among what it calls transparent, so all that is in them does.
 *
 * The canvas takes whole pictures, smoothed by four samples, or drafts of larger pixels and one sample, for GPUs that are too
 * slow to draw a whole one for every move.
 */
export class Painter {
  backdrop = new Group();
  model = new Group();
  ink = new Group();
  overlay = new Group();
  renderer;
  #scene = new Scene();
  #copier = new Copier();
  /** @type {WebGLRenderTarget | null} */
  #whole = null;
  /** The backdrop of the drafts, for as long as neither it nor the camera changes. @type {WebGLRenderTarget | null} */
  #behind = null;
  #behindOf = "";
  #backdropVersion = 0;
  #size = { width: 1, height: 1 };
  #draft = false;
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
    this.#scene.add(this.backdrop, this.model, this.ink, this.overlay);
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

  /** Pixels of the canvas: fewer for a draft. @param {boolean} draft */
  pixels(draft) {
    const { width, height } = this.#size;
    if (!draft) return { width, height };
    return { width: Math.ceil(width / COARSE), height: Math.ceil(height / COARSE) };
  }

  /**
   * Draws a picture onto the canvas.
   *
   * @param {import("three").Camera} camera
   * @param {boolean} draft
   */
  show(camera, draft) {
    if (draft !== this.#draft) {
      this.#draft = draft;
      this.#fit();
    }
    if (draft) return this.#paintDraft(camera);
    this.#whole ??= new WebGLRenderTarget(this.#size.width, this.#size.height, {
      format: RGBAFormat,
      type: UnsignedByteType,
      samples: 4,
      generateMipmaps: false,
    });
    this.paint(camera, this.#whole);
    this.#copier.copy(this.renderer, this.#whole.texture);
  }

  /** What is in the backdrop, or how it looks, has changed. */
  renewBackdrop() {
    this.#backdropVersion++;
  }

  /** @param {import("three").Camera} camera */
  #paintDraft(camera) {
    const { width, height } = this.pixels(true);
    const view = [...camera.matrixWorld.elements, ...camera.projectionMatrix.elements];
    const wanted = [this.#backdropVersion, ...this.#background, ...view].join();
    this.#behind ??= new WebGLRenderTarget(width, height, { generateMipmaps: false, depthBuffer: true });
    if (wanted !== this.#behindOf) {
      this.#behindOf = wanted;
      this.#begin(this.#behind, false);
      for (const part of [this.model, this.ink, this.overlay]) part.visible = false;
      this.renderer.render(this.#scene, camera);
      for (const part of [this.model, this.ink, this.overlay]) part.visible = true;
    }
    this.#begin(null, false);
    this.#copier.copy(this.renderer, this.#behind.texture);
    this.backdrop.visible = false;
    this.renderer.render(this.#scene, camera);
    this.backdrop.visible = true;
  }

  /**
   * Draws all layers into a target, or onto the canvas.
   *
   * @param {import("three").Camera} camera
   * @param {WebGLRenderTarget | null} target
   * @param {{ transparent?: boolean, overlay?: boolean }} [options]
   */
  paint(camera, target, { transparent = false, overlay = true } = {}) {
    this.#begin(target, transparent);
    this.overlay.visible = overlay;
    this.renderer.render(this.#scene, camera);
  }

  /** @param {WebGLRenderTarget | null} target @param {boolean} transparent */
  #begin(target, transparent) {
    const { renderer } = this;
    const [r, g, b] = this.#background;
    renderer.info.reset();
    renderer.setRenderTarget(target);
    renderer.setScissorTest(false);
    renderer.state.buffers.color.setMask(true);
    renderer.state.buffers.depth.setMask(true);
    if (transparent) renderer.state.buffers.color.setClear(0, 0, 0, 0, false);
    else renderer.state.buffers.color.setClear(r, g, b, 1, false);
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
    const { width, height } = this.pixels(this.#draft);
    this.renderer.setPixelRatio(1);
    this.renderer.setSize(width, height, false);
    this.renderer.setViewport(new Vector4(0, 0, width, height));
  }

  /** Gives up its targets, to make new ones when next asked. */
  forget() {
    this.#whole?.dispose();
    this.#behind?.dispose();
    this.#whole = this.#behind = null;
    this.#behindOf = "";
  }

  dispose() {
    this.forget();
    this.#copier.dispose();
    this.renderer.dispose();
  }
}
