import { ColorManagement, LinearSRGBColorSpace, Scene, Vector4, WebGLRenderer } from "three";
import { componentsOf } from "./colour.js";

ColorManagement.enabled = false;

/** Thrown where the browser has no WebGL 2 to give. */
export class WebGLMissing extends Error {
  name = "WebGLMissing";
}

/**
 * Owns the WebGL renderer and the order of the layers: backdrop (silhouette, never over the model), model, ink (lines and
 * irregular edges), overlay (plane, highlight).
 */
export class Painter {
  backdrop = new Scene();
  model = new Scene();
  ink = new Scene();
  overlay = new Scene();
  renderer;
  /** @type {[number, number, number]} */
  #background = [1, 1, 1];

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    const attributes = {
      alpha: false,
      depth: true,
      stencil: false,
      antialias: true,
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
    for (const layer of [this.backdrop, this.model, this.ink, this.overlay]) {
      layer.matrixWorldAutoUpdate = false;
    }
  }

  /** @returns {WebGL2RenderingContext} */
  get gl() {
    return /** @type {WebGL2RenderingContext} */ (this.renderer.getContext());
  }

  /** @param {string} colour */
  set background(colour) {
    this.#background = componentsOf(colour);
  }

  /**
   * Draws all layers into a target, or onto the canvas.
   *
   * @param {import("three").Camera} camera
   * @param {import("three").WebGLRenderTarget | null} target
   * @param {{ transparent?: boolean, overlay?: boolean }} [options]
   */
  paint(camera, target, { transparent = false, overlay = true } = {}) {
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
    renderer.render(this.backdrop, camera);
    renderer.clearDepth();
    renderer.render(this.model, camera);
    renderer.render(this.ink, camera);
    if (overlay) renderer.render(this.overlay, camera);
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
    this.renderer.setPixelRatio(1);
    this.renderer.setSize(width, height, false);
    this.renderer.setViewport(new Vector4(0, 0, width, height));
  }

  dispose() {
    this.renderer.dispose();
  }
}
