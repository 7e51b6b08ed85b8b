import { s } from "../widgets/dom.js";
import { along, valueUnder } from "./histogram_layout.js";

/**
 * @typedef {import("./histogram_layout.js").Layout} Layout
 * @typedef {import("../state/quality_filter.js").Band} Band
 * @typedef {"minimum" | "maximum"} End
 */

/** Moves shorter than this many pixels are a click, not a band. */
const CLICK = 3;

/**
 * The hand on a histogram: lines at the filter's bounds that can be dragged or moved by arrow keys, a band by dragging
 * over the bars, and nothing hidden after a double click.
 *
 * @param {SVGElement} svg
 * @param {{ band: () => Band | undefined, write: (band: Band | null, undo: string) => void, done: () => void, quantity: () => string,
 *   words: (value: number) => string }} filter
 */
export function brush(svg, filter) {
  const still = s("g");
  const bounds = s("g");
  svg.append(still, bounds);
  /** @type {Layout | null} */
  let layout = null;
  /** @type {{ end: End | null, start: number } | null} */
  let drag = null;

  /** @param {PointerEvent} event @param {Layout} at */
  function pixel(event, at) {
    const box = svg.getBoundingClientRect();
    return at.upright ? event.clientX - box.left : event.clientY - box.top;
  }

  /** @param {End} end @param {number} value */
  function moveEnd(end, value) {
    const band = filter.band();
    if (band) filter.write({ ...band, [end]: value }, "histogram");
  }

  svg.addEventListener("pointerdown", (event) => {
    if (!layout || event.button !== 0) return;
    const end = /** @type {End | undefined} */ (
      /** @type {Element} */ (event.target).closest("[data-end]")?.getAttribute("data-end")
    );
    drag = { end: end ?? null, start: pixel(event, layout) };
    svg.setPointerCapture(event.pointerId);
  });
  svg.addEventListener("pointermove", (event) => {
    if (!drag || !layout) return;
    if (event.pointerType === "mouse" && event.buttons === 0) return finish(); // let go where nobody told us
    const at = pixel(event, layout);
    if (drag.end) return moveEnd(drag.end, valueUnder(layout, at));
    if (Math.abs(at - drag.start) < CLICK) return;
    const [a, b] = [valueUnder(layout, drag.start), valueUnder(layout, at)];
    filter.write(
      { quantity: filter.quantity(), keep: "inside", minimum: Math.min(a, b), maximum: Math.max(a, b) },
      "histogram",
    );
  });
  function finish() {
    if (!drag) return;
    drag = null;
    filter.done();
  }
  for (const name of /** @type {const} */ (["pointerup", "pointercancel", "lostpointercapture"]))
    svg.addEventListener(name, finish);
  svg.addEventListener("dblclick", () => filter.write(null, "histogram-clear"));

  /** @param {Layout} at @param {End} end @param {number} value */
  function bound(at, end, value) {
    const { plot, upright } = at;
    const place = along(at, value);
    const path = upright
      ? `M${place} ${plot.y - 8}V${plot.y + plot.height}`
      : `M${plot.x} ${place}H${plot.x + plot.width + 4}`;
    const element = s(
      "g",
      {
        class: "bound",
        tabindex: 0,
        role: "slider",
        "data-end": end,
        "aria-label": end === "minimum" ? "Lowest value shown" : "Highest value shown",
        "aria-orientation": upright ? "horizontal" : "vertical",
        "aria-valuemin": at.low,
        "aria-valuemax": at.high,
        "aria-valuenow": value,
        "aria-valuetext": filter.words(value),
      },
      s("path", { d: path, class: "bound-grip" }),
      s("path", { d: path, class: "bound-line" }),
    );
    element.addEventListener("keydown", (event) => {
      const sign = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[
        /** @type {KeyboardEvent} */ (event).key
      ];
      if (!sign || !layout) return;
      event.preventDefault();
      moveEnd(
        end,
        Math.min(layout.high, Math.max(layout.low, value + (sign * (layout.high - layout.low)) / 100)),
      );
    });
    return element;
  }

  /** What the band hides, dimmed. @param {Layout} at @param {Band} band */
  function shade(at, band) {
    const { plot, upright, low, high } = at;
    const [a, b] = [band.minimum ?? low, band.maximum ?? high].map((value) => along(at, value));
    const [from, to] = [Math.min(a, b), Math.max(a, b)];
    const [start, end] = upright ? [plot.x, plot.x + plot.width] : [plot.y, plot.y + plot.height];
    const spans = band.keep === "inside" ? [[start, from], [to, end]] : [[from, to]]; // prettier-ignore
    return spans
      .filter(([p, q]) => q > p)
      .map(([p, q]) =>
        s(
          "rect",
          upright
            ? { class: "shade", x: p, y: plot.y, width: q - p, height: plot.height }
            : { class: "shade", x: plot.x, y: p, width: plot.width, height: q - p },
        ),
      );
  }

  return {
    /** @param {Layout} at @param {readonly SVGElement[]} marks */
    draw(at, marks) {
      layout = at;
      still.replaceChildren(...marks);
      const band = filter.band();
      const focused = document.activeElement?.getAttribute("data-end");
      const ends = /** @type {End[]} */ (["minimum", "maximum"]).filter((end) => band && band[end] !== null);
      bounds.replaceChildren(
        ...(band ? shade(at, band) : []),
        ...ends.map((end) => bound(at, end, /** @type {number} */ (band?.[end]))),
      );
      if (focused)
        /** @type {SVGElement | null} */ (bounds.querySelector(`[data-end="${focused}"]`))?.focus();
    },
  };
}
