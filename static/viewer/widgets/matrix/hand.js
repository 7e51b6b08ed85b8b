import { TouchPair } from "../../scene/camera/touch_pair.js";

/**
 * @typedef {import("./window.js").Point} Point
 *
 * @typedef {object} Acts  what a hand does; points are shares of the width
 * @property {(factor: number) => boolean} canZoom
 * @property {(factor: number, point: Point) => void} zoom
 * @property {(by: Point) => void} drag
 * @property {(point: Point) => void} click
 * @property {(point: Point | null) => void} hover null: it has gone
 */

/** Moves shorter than this many pixels are a click. */
const CLICK = 4;

/** How much nearer a step of the wheel of one pixel leads, as an exponent; and how many pixels a line has. */
const WHEEL = 0.002;
const LINE = 16;

/** A wheel that turned elsewhere so many milliseconds ago is still scrolling the page. */
const SCROLLING = 300;

/**
 * The mouse, and fingers, on a square: the wheel and two fingers zoom, a drag moves, a click means a point. What leads nowhere is
 * left to the page: the wheel back from the whole, one finger on it.
 *
 * @param {HTMLElement} element @param {Acts} acts
 */
export function listen(element, acts) {
  const touch = new TouchPair();
  /** @type {{ x: number, y: number, moved: boolean } | null} */
  let held = null;
  let elsewhere = -Infinity;

  /** @param {{ clientX: number, clientY: number }} event @returns {Point} */
  const pointOf = ({ clientX, clientY }) => {
    const box = element.getBoundingClientRect();
    return { x: (clientX - box.left) / box.width, y: (clientY - box.top) / box.height };
  };

  /** @param {WheelEvent} event */
  function wheel(event) {
    const { deltaY, deltaMode, ctrlKey } = event;
    const factor = Math.exp(-deltaY * (deltaMode ? LINE : 1) * (ctrlKey ? 5 : 1) * WHEEL);
    if (!acts.canZoom(factor)) return;
    if (event.timeStamp - elsewhere < SCROLLING) return void (elsewhere = event.timeStamp);
    event.preventDefault();
    acts.zoom(factor, pointOf(event));
  }

  /** @param {PointerEvent} event */
  function down(event) {
    if (event.button !== 0) return;
    element.setPointerCapture(event.pointerId);
    const { clientX: x, clientY: y } = event;
    const both = event.pointerType === "touch" && touch.add(event.pointerId, { x, y });
    held = { x, y, moved: both };
  }

  /** @param {PointerEvent} event */
  function move(event) {
    const { clientX: x, clientY: y } = event;
    const pair = touch.both ? touch.move(event.pointerId, { x, y }) : null;
    const { clientWidth: side } = element;
    if (pair) {
      acts.zoom(pair.scale, pointOf({ clientX: pair.x, clientY: pair.y }));
      acts.drag({ x: pair.dx / side, y: pair.dy / side });
    } else if (!held) acts.hover(pointOf(event));
    else if (held.moved || Math.hypot(x - held.x, y - held.y) >= CLICK) {
      acts.drag({ x: (x - held.x) / side, y: (y - held.y) / side });
      held = { x, y, moved: true };
    }
  }

  /** @param {PointerEvent} event */
  function up(event) {
    touch.remove(event.pointerId);
    if (held && !held.moved && event.type === "pointerup") acts.click(pointOf(event));
    held = null;
  }

  element.addEventListener("wheel", wheel, { passive: false });
  element.addEventListener("pointerdown", down);
  element.addEventListener("pointermove", move);
  for (const name of /** @type {const} */ (["pointerup", "pointercancel"]))
    element.addEventListener(name, up);
  element.addEventListener("pointerleave", () => acts.hover(null));
  window.addEventListener(
    "wheel",
    (event) => {
      if (!element.contains(/** @type {Node} */ (event.target))) elsewhere = event.timeStamp;
    },
    { passive: true, capture: true },
  );
}
