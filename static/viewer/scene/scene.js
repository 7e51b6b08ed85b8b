import { CameraRig } from "./camera/camera_rig.js";
import { DraftPolicy } from "./frame/draft_policy.js";
import { Emitter } from "./emitter.js";
import { FrameLoop } from "./frame/frame_loop.js";
import { cornersOf } from "../geometry/box.js";
import { standing } from "../geometry/outline.js";
import { frameOf } from "./frame_of.js";
import { Layers } from "./layers/layers.js";
import { Mark } from "./camera/mark.js";
import { Painter } from "./frame/painter.js";
import { Pictures } from "./frame/pictures.js";
import { Programs } from "./frame/programs.js";
import { isSoftware } from "./frame/software.js";
import { spreadOf } from "../state/structure.js";
import { Pointing } from "./picking/pointing.js";
import { Trackball } from "./camera/trackball.js";
import { View } from "./frame/view.js";

/**
 * @typedef {import("./scene_like.js").SceneEvents} SceneEvents
 * @typedef {import("./scene_like.js").SceneLike} SceneLike
 */

/** What is drawn over the surface, and where it was taken away. */
const OVER = /** @type {const} */ (["seeThrough", "irregular", "arrows", "marks", "curves", "reference"]);

/**
 * The drawing of one mesh on one canvas: takes the core's buffers and the status document, draws when something changed.
 *
 * @example
 * const scene = new Scene(canvas, store.status.camera, makeLighting);
 * scene.setMesh(summary);
 * scene.setStatus(store.status);
 * scene.setSurface(answer.surface);
 * scene.on("camera", (camera) => store.set({ camera }));
 * @implements {SceneLike}
 */
export class Scene {
  /** Milliseconds of the last upload, picture, first and whole lighting. @type {Record<string, number>} */
  timings = {};
  /** @type {Emitter<SceneEvents>} */
  #events = new Emitter();
  #rig;
  #painter;
  #view;
  #layers;
  #lighting;
  #pictures;
  #pointing;
  #loop;
  #trackball;
  #drafts;
  #programs;
  #idle;
  /** Whether whole pictures can be drawn without waiting for their programs: until then, drafts are. */
  #ready = false;
  /** @type {Promise<void> | null} */
  #preparing = null;
  #abort = new AbortController();
  /** @type {import("../geometry/records.js").MeshFrame} */
  #mesh = { cells: 0 };
  /** Points that stand for the mesh, 3 coordinates each. @type {ArrayLike<number>} */
  #body = [];
  /** @type {(() => void)[]} */
  #waiting = [];
  #marked = new Mark((at) => this.#events.emit("marked", at));

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {import("./types.js").CameraStatus} camera the first one
   * @param {import("../lighting/lighting.js").MakeLighting} makeLighting
   * @param {Promise<unknown>} [idle] when the processor is free for whole pictures, where it has to draw them itself
   */
  constructor(canvas, camera, makeLighting, idle = Promise.resolve()) {
    this.#idle = idle;
    this.#rig = new CameraRig(camera);
    this.#painter = new Painter(canvas);
    this.#view = new View(this.#rig, this.#painter);
    this.#layers = new Layers(this.#painter);
    this.#programs = new Programs(this.#painter.renderer);
    void this.#programs.compile([this.#layers.surface.material(true)]);
    this.#lighting = makeLighting(this.#painter.renderer, this.#layers.surface);
    this.#pictures = new Pictures(this.#view, this.#painter, this.#layers, this.#lighting);
    this.#pointing = new Pointing(this.#view, this.#painter);
    this.#loop = new FrameLoop(
      () => this.#draw(),
      (now) => this.#step(now),
    );
    this.#trackball = new Trackball(canvas, this.#rig, {
      moved: () => this.#moved(),
      ended: () => this.#events.emit("cameraend", this.#rig.status),
      clicked: (at) => this.#events.emit("click", at),
      hovered: (at) => this.#events.emit("hover", at),
      centred: ({ x, y }) =>
        this.#pointing.centre(x, y) ? this.#moved() : this.#events.emit("blank", undefined),
    });
    const { signal } = this.#abort;
    this.#drafts = new DraftPolicy(
      this.#painter.gl,
      {
        faces: () => this.#layers.surface.surface?.faces.length ?? 0,
        turning: () => this.#trackball.active,
        calm: () => this.#events.emit("calm", undefined),
      },
      signal,
    );
    canvas.addEventListener("webglcontextlost", (event) => this.#lost(event), { signal });
    canvas.addEventListener("webglcontextrestored", () => this.#restored(), { signal });
    this.resize(canvas.clientWidth || canvas.width, canvas.clientHeight || canvas.height, devicePixelRatio);
  }

  /** Pictures drawn since the scene was made. */
  get frames() {
    return this.#loop.frames;
  }

  /** Whether surfaces are wanted fast rather than whole. */
  get hurried() {
    return this.#drafts.hurried;
  }

  /** The lighting: for files, tests and measurements. */
  get lighting() {
    return this.#lighting;
  }

  /**
   * @template {keyof SceneEvents} Name
   * @param {Name} name
   * @param {(detail: SceneEvents[Name]) => void} listener
   * @returns {() => void} takes the listener off
   */
  on(name, listener) {
    return this.#events.on(name, listener);
  }

  /** Has the GPU prepare all its programs, beside other work; whole pictures are drawn from then on. @returns {Promise<void>} */
  prepare() {
    return (this.#preparing ??= this.#prepare());
  }

  async #prepare() {
    if (isSoftware(this.#painter.gl)) await this.#idle;
    if (!this.#painter.gl.isContextLost())
      await this.#programs.compile([...this.#layers.materials, ...this.#lighting.materials]);
    this.#ready = true;
    this.#loop.invalidate();
  }

  /** Begins another mesh: what was drawn of the last one goes. @param {import("../geometry/records.js").MeshFrame} mesh */
  setMesh(mesh) {
    this.#mesh = mesh;
    this.#body = mesh.outline?.length ? mesh.outline : cornersOf(frameOf(mesh));
    this.setBeside(null);
    this.#drafts.forget();
    this.#layers.outward = false;
    this.setSurface(null);
    this.setSilhouette(null);
    for (const layer of OVER) this.setOver(layer, null);
    this.setCellColours(null);
    this.mark(null);
    this.#rig.covered = 0;
    this.#layers.plane.set(null, mesh);
  }

  /** @param {Float32Array | null} points of another body, 3 coordinates each: the camera is fitted to both */
  setBeside(points) {
    this.#rig.body = points ? Float32Array.from([...Array.from(this.#body), ...points]) : this.#body;
    this.#touch();
  }

  /** Whether every cell is valid at its corners: then the backs of faces need not be drawn. @param {boolean} outward */
  set outward(outward) {
    this.#layers.outward = outward;
  }

  /**
   * @param {import("../geometry/records.js").Surface | null} surface
   * @param {boolean} [same] as the one on the screen, with more to it: nothing has moved
   */
  setSurface(surface, same = false) {
    const started = performance.now();
    this.#layers.setSurface(surface);
    this.#enclose();
    this.#pointing.set(surface);
    this.#lighting.restart();
    this.timings.upload = performance.now() - started;
    if (!same) this.#drafts.surfaced();
    this.#loop.invalidate();
  }

  /** @param {import("../geometry/records.js").Silhouette | null} silhouette */
  setSilhouette(silhouette) {
    this.#layers.setSilhouette(silhouette);
    this.#enclose();
    this.#loop.invalidate();
  }

  /** @type {SceneLike["setOver"]} */
  setOver(layer, record) {
    this.#layers[layer].set(/** @type {never} */ (record));
    this.#enclose();
    this.#loop.invalidate();
  }

  /** @param {Float32Array | null} positions in the colour map, one per cell @param {boolean} [highFirst] whether its first colour is that of high values */
  setCellColours(positions, highFirst = false) {
    this.#layers.setCellColours(positions, highFirst);
    this.#loop.invalidate();
  }

  /**
   * Draws as the status says; parts that have not changed cost nothing, and nothing changed draws nothing.
   *
   * @param {import("./types.js").SceneStatus} status
   */
  setStatus(status) {
    if (status.camera && this.#rig.set(status.camera)) this.#touch();
    if (!this.#layers.look(status)) return;
    if (status.lighting?.mode) this.#lighting.mode = status.lighting.mode;
    if (status.arrows) this.#enclose(); // their length may have changed
    if (status.structure && this.#rig.reach(spreadOf(status.structure))) this.#touch();
    this.#loop.invalidate();
  }

  /** @param {number} width CSS pixels @param {number} height @param {number} [pixelRatio] device pixels to one of them */
  resize(width, height, pixelRatio = devicePixelRatio) {
    this.#view.resize(width, height, pixelRatio);
    this.#loop.flush(); // a canvas whose size changed is blank until drawn
    this.#loop.invalidate();
  }

  /** The face under a place of the canvas, in CSS pixels from left and top. @param {number} x @param {number} y */
  pick(x, y) {
    return this.#pointing.pick(x, y);
  }

  /** @param {number | null} face tag of the face to highlight */
  highlight(face) {
    if (this.#layers.highlight.set(this.#layers.surface.surface, face)) this.#loop.invalidate();
  }

  /**
   * Outlines a cell through everything; `marked` tells where it stands whenever that changes.
   *
   * @param {Float32Array | null} edges of the cell, 6 numbers for each
   */
  mark(edges) {
    this.#layers.outline.set(edges);
    this.#marked.edges = edges;
    this.#enclose();
    this.#loop.invalidate();
  }

  /** @param {number} pixels CSS pixels at the right of the canvas that something covers: the view's middle is that of the rest */
  set covered(pixels) {
    if (this.#view.cover(pixels)) this.#touch();
  }

  /** @param {import("./types.js").Plane | null} plane */
  showPlane(plane) {
    this.#layers.plane.set(plane, this.#mesh);
    this.#enclose();
    this.#loop.invalidate();
  }

  /**
   * The camera that sees what is shown whole, from the present direction; null where nothing is.
   *
   * @param {number} [filled] part of the picture that it fills
   * @returns {Partial<import("./types.js").CameraStatus> | null}
   */
  cameraOnShown(filled) {
    const { surface } = this.#layers.surface;
    return surface?.positions.length ? this.#rig.around(standing(surface.positions), filled) : null;
  }

  /** Camera as the status document writes it. @returns {import("./types.js").CameraStatus} */
  get camera() {
    return this.#rig.status;
  }

  /** Half the height of what a picture of a shape sees, at the target's distance, in diagonals. @param {number} aspect width over height */
  halfHeight(aspect) {
    return this.#view.halfHeight(aspect);
  }

  /** Draws nothing on the canvas from now on, until somebody waits for it: pictures for files are drawn apart. */
  rest() {
    this.#loop.resting = true;
  }

  /** @returns {Promise<void>} when the picture is drawn and will not change by itself */
  settled() {
    this.#loop.resting = false;
    void this.prepare();
    this.#loop.invalidate();
    return new Promise((resolve) => this.#waiting.push(resolve));
  }

  /**
   * The drawing as a PNG of any size, lighting completed before; without gizmo, plane and highlight.
   *
   * @param {import("./scene_like.js").PictureOptions} [options]
   * @returns {Promise<Blob>}
   */
  async screenshot({ width, height, transparent = false } = {}) {
    await this.#lighting.complete();
    const whole = this.#painter.pixels(false);
    return this.#pictures.take({
      width: width ?? whole.width,
      height: height ?? whole.height,
      transparent,
      drawn: () => this.#loop.invalidate(),
    });
  }

  /** What is drawn. @returns {import("./scene_like.js").DrawnCounts} */
  drawn() {
    return this.#layers.counts;
  }

  invalidate() {
    this.#loop.invalidate();
  }

  /** Draws what has changed at once, so that the GPU begins before the screen asks for it. */
  flush() {
    if (this.#loop.stale) this.#loop.flush();
  }

  /** Near and far planes follow what is drawn. */
  #enclose() {
    this.#rig.drawn = this.#layers.box ?? frameOf(this.#mesh);
  }

  #touch() {
    this.#drafts.touch();
    this.#loop.invalidate();
  }

  #moved() {
    this.#touch();
    this.#events.emit("camera", this.#rig.status);
  }

  /** @param {number} now */
  #step(now) {
    if (!this.#ready) return { again: false, draw: false };
    return this.#drafts.step(now, (busy, slow) => this.#lighting.step(busy, slow));
  }

  #draw() {
    const started = performance.now();
    const draft = this.#drafts.begin(started, this.#ready);
    this.#pictures.show(draft, this.#drafts.held, !this.#ready);
    this.timings.frame = performance.now() - started;
    this.#drafts.end();
    this.#marked.look(this.#rig.camera, this.#view.size);
    // The first picture goes to the screen before the GPU gets more to do.
    if (!this.#ready && this.#mesh.cells) requestAnimationFrame(() => setTimeout(() => void this.prepare()));
    if (draft || !this.#lighting.settled) return;
    this.timings.lighting = this.#lighting.elapsed;
    for (const resolve of this.#waiting.splice(0)) resolve();
  }

  /** @param {Event} event */
  #lost(event) {
    event.preventDefault();
    this.#loop.stopped = true;
    this.#lighting.forget();
    this.#layers.forget();
    this.#pointing.forget();
    this.#events.emit("contextlost", undefined);
  }

  #restored() {
    this.#loop.stopped = false;
    this.#events.emit("contextrestored", undefined);
  }

  dispose() {
    this.#loop.stopped = true;
    this.#abort.abort();
    const parts = [this.#trackball, this.#layers, this.#pointing, this.#lighting, this.#painter];
    for (const part of parts) part.dispose();
    this.#events.clear();
  }
}
