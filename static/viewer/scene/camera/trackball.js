import { Quaternion, Vector3 } from "three";
import { TouchPair } from "./touch_pair.js";

const PAUSE = 600; // milliseconds without another turn of the wheel after which it has come to an end
const STILL = 3; // CSS pixels that a pointer may shake while it clicks
const AXIS = new Vector3();
const TURN = new Quaternion();

/**
 * Turns pointer, wheel, touch and arrow keys into moves of a camera rig. Turning is that of a ball under the pointer
 * (Bell's mapping: a sphere that runs out into a hyperbola), applied in the view's own frame, so no pole exists.
 *
 * @example
 * const trackball = new Trackball(canvas, rig, { moved, clicked, hovered, centred });
 */
export class Trackball {
  #canvas;
  #rig;
  #listen;
  #abort = new AbortController();
  #touches = new TouchPair();
  /** @type {{ id: number, button: number, x: number, y: number, startX: number, startY: number, dragged: boolean } | null} */
  #drag = null;
  /** Runs out when wheel, keys or fingers have paused. @type {ReturnType<typeof setTimeout> | undefined} */
  #pause;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {import("./camera_rig.js").CameraRig} rig
   * @param {{ moved: () => void, ended: () => void, clicked: (at: {x: number, y: number, event: PointerEvent}) => void,
   *   hovered: (at: {x: number, y: number, event: PointerEvent} | null) => void,
   *   centred: (at: {x: number, y: number}) => void }} listen
   */
  constructor(canvas, rig, listen) {
    this.#canvas = canvas;
    this.#rig = rig;
    this.#listen = listen;
    canvas.style.touchAction = "none";
    if (!canvas.hasAttribute("tabindex")) canvas.tabIndex = 0;
    const signal = this.#abort.signal;
    canvas.addEventListener("pointerdown", (event) => this.#down(event), { signal });
    canvas.addEventListener("pointermove", (event) => this.#move(event), { signal });
    canvas.addEventListener("pointerup", (event) => this.#up(event), { signal });
    canvas.addEventListener("pointercancel", (event) => this.#up(event), { signal });
    canvas.addEventListener("lostpointercapture", (event) => this.#up(event), { signal });
    canvas.addEventListener("pointerleave", () => !this.#drag && listen.hovered(null), { signal });
    canvas.addEventListener("wheel", (event) => this.#wheel(event), { signal, passive: false });
    canvas.addEventListener("contextmenu", (event) => event.preventDefault(), { signal });
    canvas.addEventListener("dblclick", (event) => listen.centred(this.#place(event)), { signal });
    canvas.addEventListener("keydown", (event) => this.#key(event), { signal });
  }

  /** Whether the pointer holds the model at this moment. */
  get active() {
    return this.#drag?.dragged === true || this.#touches.both;
  }

  dispose() {
    this.#abort.abort();
    clearTimeout(this.#pause);
  }

  /** The camera was moved by a step, which others may follow. */
  #stepped() {
    this.#listen.moved();
    clearTimeout(this.#pause);
    this.#pause = setTimeout(() => this.#ended(), PAUSE);
  }

  #ended() {
    clearTimeout(this.#pause);
    this.#pause = undefined;
    this.#listen.ended();
  }

  /** Size of the canvas in CSS pixels, none below 1. */
  get #size() {
    return { width: Math.max(1, this.#canvas.clientWidth), height: Math.max(1, this.#canvas.clientHeight) };
  }

  /** @param {{ clientX: number, clientY: number }} event @returns {{ x: number, y: number }} CSS pixels */
  #place(event) {
    const box = this.#canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  /** @param {PointerEvent} event */
  #down(event) {
    this.#canvas.focus({ preventScroll: true });
    if (event.pointerType === "touch" && this.#touches.add(event.pointerId, this.#place(event))) {
      this.#drag = null;
      return;
    }
    if (this.#drag) return;
    if (this.#pause !== undefined) this.#ended();
    const { x, y } = this.#place(event);
    const button = event.button;
    this.#drag = { id: event.pointerId, button, x, y, startX: x, startY: y, dragged: false };
    this.#canvas.setPointerCapture(event.pointerId);
  }

  /** @param {PointerEvent} event */
  #move(event) {
    const { x, y } = this.#place(event);
    if (event.pointerType === "touch") {
      const gesture = this.#touches.move(event.pointerId, { x, y });
      if (gesture) {
        this.panBy(gesture.dx, gesture.dy);
        this.zoomBy(gesture.scale, gesture.x, gesture.y);
        this.rollBy(gesture.roll);
        this.#stepped();
        return;
      }
    }
    const drag = this.#drag;
    if (!drag || drag.id !== event.pointerId) {
      if (!drag && event.buttons === 0) this.#listen.hovered({ x, y, event });
      return;
    }
    if (event.pointerType === "mouse" && event.buttons === 0) return this.#up(event); // let go where nobody told us
    if (!drag.dragged && Math.hypot(x - drag.startX, y - drag.startY) <= STILL) return;
    if (!drag.dragged) this.#listen.hovered(null);
    drag.dragged = true;
    if (drag.button === 2 || drag.button === 1) this.panBy(x - drag.x, y - drag.y);
    else this.turn(drag.x, drag.y, x, y);
    drag.x = x;
    drag.y = y;
    this.#listen.moved();
  }

  /** @param {PointerEvent} event */
  #up(event) {
    this.#touches.remove(event.pointerId);
    const drag = this.#drag;
    if (!drag || drag.id !== event.pointerId) return;
    this.#drag = null;
    if (drag.dragged) this.#ended();
    else if (event.type === "pointerup" && drag.button === 0) {
      this.#listen.clicked({ x: drag.startX, y: drag.startY, event });
    }
  }

  /** @param {WheelEvent} event */
  #wheel(event) {
    if (window !== parent && !document.hasFocus()) return; // in a frame the page around scrolls, until it was clicked
    event.preventDefault();
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 18 : event.deltaMode === 2 ? 400 : 1;
    const pixels = Math.max(-300, Math.min(300, event.deltaY * unit));
    const { x, y } = this.#place(event);
    this.zoomBy(Math.exp(-pixels * (event.ctrlKey ? 0.01 : 0.0015)), x, y);
    this.#stepped();
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const arrow = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
    if (!arrow || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    if (event.shiftKey) this.panBy(24 * arrow[0], 24 * arrow[1]);
    else this.#turnAbout(AXIS.set(arrow[1], arrow[0], 0), (5 * Math.PI) / 180);
    this.#stepped();
  }

  /**
   * Turns the model as a ball would turn whose surface is dragged from one place to another.
   *
   * @param {number} x0
   * @param {number} y0
   * @param {number} x1
   * @param {number} y1
   */
  turn(x0, y0, x1, y1) {
    const from = this.#onBall(x0, y0);
    const to = this.#onBall(x1, y1);
    const angle = from.angleTo(to);
    if (angle > 0) this.#turnAbout(AXIS.crossVectors(from, to).normalize(), 1.6 * angle);
  }

  /** @param {Vector3} axis in the view's frame, the model turns about it @param {number} angle radians */
  #turnAbout(axis, angle) {
    this.#rig.release();
    this.#rig.orientation.multiply(TURN.setFromAxisAngle(axis.normalize(), -angle)).normalize();
  }

  /** @param {number} angle radians, the model turns counter-clockwise on the screen */
  rollBy(angle) {
    if (angle !== 0) this.#turnAbout(AXIS.set(0, 0, 1), angle);
  }

  /** @param {number} dx CSS pixels @param {number} dy downwards */
  panBy(dx, dy) {
    this.#rig.release();
    const scale = (2 * this.#rig.halfHeight) / this.#size.height;
    this.#rig.target.add(new Vector3(-dx * scale, dy * scale, 0).applyQuaternion(this.#rig.orientation));
  }

  /**
   * Brings the model nearer; what stands under the place stays there.
   *
   * @param {number} factor above 1: larger
   * @param {number} x CSS pixels
   * @param {number} y
   */
  zoomBy(factor, x, y) {
    const rig = this.#rig;
    rig.release();
    const distance = Math.min(50, Math.max(1e-4, rig.distance / factor));
    const { width, height } = this.#size;
    const under = rig.pointAt((2 * x) / width - 1, 1 - (2 * y) / height);
    rig.target.lerp(under, 1 - distance / rig.distance);
    rig.distance = distance;
  }

  /** @param {number} x @param {number} y @returns {Vector3} */
  #onBall(x, y) {
    const { width, height } = this.#size;
    const radius = 0.42 * Math.min(width, height);
    const u = (x - width / 2) / radius;
    const v = (height / 2 - y) / radius;
    const square = u * u + v * v;
    return new Vector3(u, v, square < 0.5 ? Math.sqrt(1 - square) : 0.5 / Math.sqrt(square));
  }
}
