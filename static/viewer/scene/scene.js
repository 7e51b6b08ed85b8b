import { CameraRig } from "./camera_rig.js";
import { CellColours } from "./cell_colours.js";
import { Emitter } from "./emitter.js";
import { FrameLoop } from "./frame_loop.js";
import { LinesLayer } from "./lines_layer.js";
import { Painter } from "./painter.js";
import { SurfaceLayer } from "./surface_layer.js";
import { Trackball } from "./trackball.js";

/** Ink of a surface edge by the number of shown cells around it: darkness-coded edges. Row 0: all alike. */
const EDGE_STYLES = [1, 0.35, 0.75, 1].map((ink) => ({ colour: "#000000", ink }));

/**
 * The drawing of one mesh on one canvas: takes the core's buffers and the status document, draws when something changed.
 *
 * @example
 * const scene = new Scene(canvas);
 * scene.setMesh(summary);
 * scene.setSurface(answer.surface);
 * scene.setStatus(store.status);
 * scene.on("camera", (camera) => store.set({ camera }));
 */
export class Scene {
  /** Milliseconds of the last upload and picture (submission, not execution). @type {Record<string, number>} */
  timings = {};
  #canvas;
  #events = new Emitter();
  #rig = new CameraRig();
  #painter;
  #loop;
  #trackball;
  #colours = new CellColours();
  #surface;
  #edges = new LinesLayer(EDGE_STYLES, { fade: true });
  #pixelRatio = 1;
  #cells = 0;

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#canvas = canvas;
    this.#painter = new Painter(canvas);
    this.#surface = new SurfaceLayer(this.#colours);
    this.#painter.model.add(this.#surface.mesh);
    this.#painter.ink.add(this.#edges.mesh);
    this.#loop = new FrameLoop(
      () => this.#draw(),
      () => ({ again: false, draw: false }),
    );
    this.#trackball = new Trackball(canvas, this.#rig, {
      moved: () => this.#moved(),
      ended: () => this.#loop.invalidate(),
      clicked: (at) => this.#events.emit("click", at),
      hovered: (at) => this.#events.emit("hover", at),
      centred: () => {},
    });
    this.resize(canvas.clientWidth || canvas.width, canvas.clientHeight || canvas.height, devicePixelRatio);
  }

  /** Pictures drawn since the scene was made. */
  get frames() {
    return this.#loop.frames;
  }

  /**
   * @param {string} name "camera", "click", "hover", "contextlost", "contextrestored"
   * @param {(detail: any) => void} listener
   */
  on(name, listener) {
    return this.#events.on(name, listener);
  }

  /** @param {import("./types.js").MeshFrame} mesh */
  setMesh(mesh) {
    this.#cells = mesh.cells;
    this.setSurface(null);
    this.setCellColours(null);
  }

  /** @param {import("./types.js").Surface | null} surface */
  setSurface(surface) {
    this.#surface.set(surface);
    this.#edges.set(surface?.edges ?? new Float32Array(0), surface?.edge_cells ?? null);
    this.#loop.invalidate();
  }

  /** @param {Float32Array | null} positions in the colour map, one per cell */
  setCellColours(positions) {
    this.#colours.setPositions(positions);
    this.#surface.uniforms.cellValues.value = this.#colours.values;
    this.#loop.invalidate();
  }

  /** @param {import("./types.js").SceneStatus} status */
  setStatus(status) {
    if (status.background) this.#painter.background = status.background;
    if (status.colour) {
      this.#surface.setColour(status.colour);
      this.#colours.setMap(status.colour.by === "kind" ? "kind" : (status.colour.map ?? "parula"));
    }
    if (status.separation) {
      this.#edges.opacity = status.separation.line_opacity ?? 0.5;
      this.#edges.width = status.separation.line_width ?? 1;
    }
    if (status.lighting) this.#surface.lighting = status.lighting.mode ?? "direct";
    if (status.camera) this.#rig.set(status.camera);
    this.#loop.invalidate();
  }

  /** @param {number} width CSS pixels @param {number} height @param {number} pixelRatio */
  resize(width, height, pixelRatio) {
    this.#pixelRatio = pixelRatio;
    this.#painter.resize(
      Math.max(1, Math.round(width * pixelRatio)),
      Math.max(1, Math.round(height * pixelRatio)),
    );
    this.#rig.aspect = width / height;
    this.#loop.invalidate();
  }

  invalidate() {
    this.#loop.invalidate();
  }

  #moved() {
    this.#events.emit("camera", this.#rig.status);
    this.#loop.invalidate();
  }

  #draw() {
    const started = performance.now();
    const { width, height } = this.#canvas;
    this.#rig.update();
    const pixel =
      (2 * this.#rig.halfHeight) / height / (this.#rig.projection === "perspective" ? this.#rig.distance : 1);
    this.#edges.mesh.visible = this.#edges.count > 0;
    this.#edges.view({ width, height, pixelRatio: this.#pixelRatio, pixel });
    this.#painter.paint(this.#rig.camera, null);
    this.timings.frame = performance.now() - started;
  }

  dispose() {
    this.#trackball.dispose();
    this.#surface.dispose();
    this.#edges.dispose();
    this.#colours.dispose();
    this.#painter.dispose();
    this.#events.clear();
  }
}
