import { Vector3 } from "three";
import { Lighting } from "../lighting/lighting.js";
import { CameraRig } from "./camera/camera_rig.js";
import { Emitter } from "./emitter.js";
import { FrameLoop } from "./frame/frame_loop.js";
import { Layers } from "./layers/layers.js";
import { Motion } from "./frame/motion.js";
import { Pace } from "./frame/pace.js";
import { Painter } from "./frame/painter.js";
import { Picker } from "./picker.js";
import { planeExtent } from "./layers/plane_extent.js";
import { release } from "./layers/release.js";
import { takePicture } from "./frame/screenshot.js";
import { Trackball } from "./camera/trackball.js";
import { UNSEEN } from "./layers/unseen.js";

/**
 * @typedef {import("./scene_like.js").SceneEvents} SceneEvents
 * @typedef {import("./scene_like.js").SceneLike} SceneLike
 */

/**
 * The drawing of one mesh on one canvas: takes the core's buffers and the status document, draws when something changed.
 *
 * @example
 * const scene = new Scene(canvas);
 * scene.setMesh(summary);
 * scene.setStatus(store.status);
 * scene.setSurface(answer.surface);
 * scene.on("camera", (camera) => store.set({ camera }));
 * @implements {SceneLike}
 */
export class Scene {
  /** Milliseconds of the last upload, picture, first and whole lighting. @type {Record<string, number>} */
  timings = {};
  #canvas;
  /** @type {Emitter<SceneEvents>} */
  #events = new Emitter();
  #rig = new CameraRig();
  #painter;
  #loop;
  #trackball;
  #lighting;
  #motion;
  #pace;
  #picker;
  #layers;
  #pixelRatio = 1;
  #size = { width: 1, height: 1 };
  /** Whether the canvas shows a draft. */
  #draft = false;
  #abort = new AbortController();
  /** @type {import("../geometry/records.js").MeshFrame} */
  #mesh = { cells: 0 };
  /** @type {(() => void)[]} */
  #waiting = [];

  /** @param {HTMLCanvasElement} canvas */
  constructor(canvas) {
    this.#canvas = canvas;
    this.#painter = new Painter(canvas);
    this.#layers = new Layers(this.#painter);
    this.#lighting = new Lighting(this.#painter.renderer, this.#layers.surface);
    this.#picker = new Picker(this.#painter.renderer);
    this.#pace = new Pace(this.#painter.gl);
    this.#loop = new FrameLoop(
      () => this.#draw(),
      (now) => this.#step(now),
    );
    this.#trackball = new Trackball(canvas, this.#rig, {
      moved: () => this.#moved(),
      ended: () => this.#events.emit("cameraend", this.#rig.status),
      clicked: (at) => this.#events.emit("click", at),
      hovered: (at) => this.#events.emit("hover", at),
      centred: ({ x, y }) => this.#centre(x, y),
    });
    const { signal } = this.#abort;
    this.#motion = new Motion(
      {
        slow: () => this.#pace.slow(this.#layers.surface.surface?.faces.length ?? 0),
        released: () => this.#events.emit("calm", undefined),
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

  /** The lighting, for tests and measurements. */
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

  /** Has the GPU prepare all its programs, on a face that stands behind the eye, before there is a mesh. */
  warmUp() {
    if (this.#mesh.cells > 0 || this.#painter.gl.isContextLost()) return;
    const rig = new CameraRig();
    rig.update();
    this.#layers.setSurface(UNSEEN);
    this.#layers.setSilhouette(UNSEEN);
    this.#lighting.restart();
    this.#lighting.object.advance(1);
    for (const draft of [true, false]) {
      this.#layers.view({ width: 1, height: 1, pixelRatio: 1, pixel: 1, draft, outside: false });
      this.#painter.show(rig.camera, draft);
    }
    this.#layers.setSilhouette(null);
    this.setSurface(null);
  }

  /** Begins another mesh: what was drawn of the last one goes. @param {import("../geometry/records.js").MeshFrame} mesh */
  setMesh(mesh) {
    this.#mesh = mesh;
    this.#pace.forget();
    this.#layers.outward = false;
    this.setSurface(null);
    this.setSilhouette(null);
    this.setIrregular(null);
    this.setCellColours(null);
    this.#layers.plane.set(null, 0, 1);
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
    this.#picker.set(surface);
    this.#lighting.restart();
    this.timings.upload = performance.now() - started;
    if (same) return this.#loop.invalidate();
    this.#motion.surfaced();
    this.#loop.invalidate();
  }

  /** @param {import("../geometry/records.js").Silhouette | null} silhouette */
  setSilhouette(silhouette) {
    this.#layers.setSilhouette(silhouette);
    this.#loop.invalidate();
  }

  /** @param {import("../geometry/records.js").Irregular | null} irregular */
  setIrregular(irregular) {
    this.#layers.irregular.set(irregular);
    this.#loop.invalidate();
  }

  /** @param {Float32Array | null} positions in the colour map, one per cell */
  setCellColours(positions) {
    this.#layers.setCellColours(positions);
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
    this.#loop.invalidate();
  }

  /** @param {number} width CSS pixels @param {number} height @param {number} [pixelRatio] device pixels to one of them */
  resize(width, height, pixelRatio = devicePixelRatio) {
    this.#size = { width: Math.max(1, width), height: Math.max(1, height) };
    this.#pixelRatio = pixelRatio;
    const pixels = [this.#size.width, this.#size.height].map((side) =>
      Math.max(1, Math.round(side * pixelRatio)),
    );
    this.#painter.resize(pixels[0], pixels[1]);
    this.#loop.flush(); // a canvas whose size changed is blank until drawn
    this.#loop.invalidate();
  }

  /**
   * The face under a place of the canvas.
   *
   * @param {number} x CSS pixels from the canvas's left
   * @param {number} y from its top
   * @returns {import("./scene_like.js").FaceHit | null}
   */
  pick(x, y) {
    const row = this.#rowAt(x, y);
    if (row < 0 || !this.#layers.surface.surface) return null;
    const face = this.#layers.surface.surface.faces[row];
    return { face, cell: face >>> 3, localFace: face & 7 };
  }

  /** @param {number} x @param {number} y @returns {number} row of the face, -1 for none */
  #rowAt(x, y) {
    if (this.#painter.gl.isContextLost()) return -1;
    this.#aim(this.#size.width / this.#size.height);
    const { width, height } = this.#painter.pixels(false);
    const scale = width / this.#size.width;
    return this.#picker.rowAt(this.#rig.camera, x * scale, y * scale, width, height);
  }

  /** @param {number | null} face tag of the face to highlight */
  highlight(face) {
    if (this.#layers.highlight.set(this.#layers.surface.surface, face)) this.#loop.invalidate();
  }

  /** @param {import("./types.js").Plane | null} plane */
  showPlane(plane) {
    if (!plane) this.#layers.plane.set(null, 0, 1);
    else {
      const [low, high] = plane.extent ?? planeExtent(this.#mesh, plane.normal);
      this.#layers.plane.set(plane.normal, low + plane.offset * (high - low), 1);
    }
    this.#loop.invalidate();
  }

  /** Camera as the status document writes it. @returns {import("./types.js").CameraStatus} */
  get camera() {
    return this.#rig.status;
  }

  /** @returns {Promise<void>} when the picture is drawn and will not change by itself */
  settled() {
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
    return this.#picture({ width: width ?? whole.width, height: height ?? whole.height, transparent });
  }

  /** @param {{ width: number, height: number, transparent: boolean }} options */
  #picture({ width, height, transparent }) {
    const pixelRatio = Math.max(1, height / this.#size.height);
    return takePicture(this.#painter, {
      width,
      height,
      transparent,
      draw: (target, tile, scale) => {
        this.#aim(width / height);
        const { camera } = this.#rig;
        camera.setViewOffset(width * scale, height * scale, tile.x, tile.y, tile.width, tile.height);
        this.#prepare({
          width: tile.width,
          height: tile.height,
          whole: height * scale,
          pixelRatio: pixelRatio * scale,
          draft: false,
        });
        this.#painter.paint(camera, target, { transparent, overlay: false });
        camera.clearViewOffset();
        this.#loop.invalidate();
      },
    });
  }

  /** What is drawn. @returns {import("./scene_like.js").DrawnCounts} */
  drawn() {
    const surface = this.#layers.surface.surface;
    if (!surface) return { faces: 0, triangles: 0, edges: 0, cells: 0 };
    return {
      faces: surface.faces.length,
      triangles: 2 * surface.faces.length,
      edges: this.#layers.edgeCount,
      cells: new Set(surface.cells).size,
    };
  }

  invalidate() {
    this.#loop.invalidate();
  }

  /** Draws what has changed at once, so that the GPU begins before the screen asks for it. */
  flush() {
    if (this.#loop.stale) this.#loop.flush();
  }

  #touch() {
    this.#motion.touch();
    this.#loop.invalidate();
  }

  #moved() {
    this.#touch();
    this.#events.emit("camera", this.#rig.status);
  }

  /** Makes the point of the model under a place the centre that the view turns about. @param {number} x @param {number} y */
  #centre(x, y) {
    const row = this.#rowAt(x, y);
    if (row < 0) return;
    const ray = this.#rig.rayAt((2 * x) / this.#size.width - 1, 1 - (2 * y) / this.#size.height);
    const place = this.#picker.meet(row, ray);
    if (!place) return;
    const forward = new Vector3(0, 0, -1).applyQuaternion(this.#rig.orientation);
    if (this.#rig.projection === "perspective") {
      this.#rig.distance = Math.max(1e-4, place.clone().sub(ray.origin).dot(forward));
    }
    this.#rig.target.copy(place);
    this.#moved();
  }

  /** @param {number} aspect */
  #aim(aspect) {
    this.#rig.aspect = aspect;
    this.#rig.update();
  }

  /**
   * One turn of the light between pictures.
   *
   * @param {number} now
   * @returns {{ again: boolean, draw: boolean }}
   */
  #step(now) {
    const { held, slow } = this.#motion;
    const busy = this.#busy(now);
    // A slow GPU does one large thing at a time, so that the next move finds it free soon, and gathers no light on a
    // surface that another follows.
    if (slow && (this.#pace.watching || (busy && !this.#motion.still(now))))
      return { again: true, draw: false };
    if (this.#draft && held && !busy) this.#events.emit("calm", undefined);
    const { again, draw } = this.#lighting.step(busy, slow);
    return { again: again || this.#draft, draw: draw || (this.#draft && !busy) };
  }

  /** Whether surfaces are wanted fast rather than whole. */
  get hurried() {
    return this.#motion.hurried;
  }

  /** @param {number} now */
  #busy(now) {
    return this.#trackball.active || this.#motion.busy(now);
  }

  /**
   * @param {{ width: number, height: number, whole: number, pixelRatio: number, draft: boolean }} target its pixels, and the
   *   height of the whole picture, of which it may be a tile
   */
  #prepare({ width, height, whole, pixelRatio, draft }) {
    const perspective = this.#rig.projection === "perspective";
    const pixel = (2 * this.#rig.halfHeight) / whole / (perspective ? this.#rig.distance : 1);
    const { outside } = this.#rig;
    this.#layers.view({ width, height, pixelRatio, pixel, draft, outside });
    this.#lighting.prepare(this.#rig.camera, { width, height, perUnit: 1 / pixel, draft });
  }

  /** Pixels to a CSS pixel in a picture of that width. @param {number} width */
  #ratioOf(width) {
    return (this.#pixelRatio * width) / this.#painter.pixels(false).width;
  }

  #draw() {
    const started = performance.now();
    const draft = this.#busy(started) && this.#motion.slow;
    this.#draft = draft;
    const { width, height } = this.#painter.pixels(draft);
    const pixelRatio = this.#ratioOf(width);
    this.#aim(this.#size.width / this.#size.height);
    this.#prepare({ width, height, whole: height, pixelRatio, draft });
    this.#painter.show(this.#rig.camera, draft, this.#motion.held);
    const canvas = this.#painter.canvas.width;
    this.#painter.corner((renderer) =>
      this.#layers.gizmo.draw(renderer, this.#rig.orientation, canvas, this.#ratioOf(canvas)),
    );
    this.timings.frame = performance.now() - started;
    if (draft) return;
    this.#pace.watch();
    if (!this.#lighting.settled) return;
    this.timings.lighting = this.#lighting.elapsed;
    for (const resolve of this.#waiting.splice(0)) resolve();
  }

  /** @param {Event} event */
  #lost(event) {
    event.preventDefault();
    this.#loop.stopped = true;
    this.#lighting.forget();
    this.#layers.forget();
    release(this.#picker.scene);
    this.#events.emit("contextlost", undefined);
  }

  #restored() {
    this.#loop.stopped = false;
    this.#events.emit("contextrestored", undefined);
  }

  dispose() {
    this.#loop.stopped = true;
    this.#abort.abort();
    this.#trackball.dispose();
    this.#layers.dispose();
    this.#picker.dispose();
    this.#lighting.dispose();
    this.#painter.dispose();
    this.#events.clear();
  }
}
