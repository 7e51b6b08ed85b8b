import { mapColours } from "../colours/palettes.js";
import { bandOf, withBand } from "./quality_filter.js";
import { quantityOf } from "../state/quantity.js";
import { decimal } from "../state/numbers.js";
import { measured, titled } from "../state/units.js";
import { watch } from "../widgets/bind.js";
import { h, s, setText } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";
import { brush } from "../charts/brush.js";
import { layOut } from "../charts/histogram_layout.js";
import { marks } from "../charts/histogram_svg.js";
import { withSecond } from "../charts/second.js";
import { followSecond } from "../state/second_facts.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/** Pixels above and below, and at both sides of, an enlarged histogram. */
const LARGE_RIM = 72;
const LARGE_PADDING = 32;

/** Heights in pixels by orientation. */
const HEIGHTS = { horizontal: 120, vertical: 280 };

/**
 * The histogram, which is the legend of the picture too: bars in the map's colours, the acceptable range as a bracket,
 * the filter's bounds as lines that can be dragged. Dragging over the bars shows a band, a double click all.
 *
 * @param {Context} context
 */
export function histogramPanel(context) {
  const svg = s("svg", { class: "histogram", role: "group" });
  const caption = h("p", { class: "visually-hidden" });
  const note = h("p", { class: "quiet histogram-note", hidden: true });
  let large = false;
  const enlarge = h(
    "button",
    {
      type: "button",
      class: "button button-icon plain histogram-enlarge",
      "aria-label": "Enlarge the histogram",
      title: "To the height of the picture, and back",
      "aria-pressed": "false",
      onclick: () => {
        large = !large;
        element.classList.toggle("histogram-large", large);
        enlarge.setAttribute("aria-pressed", String(large));
        draw();
      },
    },
    icon("isolate"),
  );
  const key = h("p", { class: "quiet histogram-note", hidden: true });
  const element = h("div", { class: "histogram-frame" }, enlarge, svg, caption, key, note);
  const hand = brush(svg, {
    band: () => bandOf(context),
    write: (band, undo) => context.store.set(withBand(context, band), { undo }),
    done: () => context.store.seal(),
    quantity: () => quantityOf(context).id,
    words: (value) => measured(value, quantityOf(context).unit),
  });

  const dark = matchMedia("(prefers-color-scheme: dark)");

  function draw() {
    const own = context.facts.get("histogram");
    element.hidden = !own;
    if (!own || !element.clientWidth) return;
    const data = withSecond(own, context.facts);
    const quantity = quantityOf(context);
    const { orientation, scale } = context.store.status.histogram;
    const frame = {
      width: element.clientWidth - (large ? LARGE_PADDING : 0),
      height: large ? element.clientHeight - LARGE_RIM : HEIGHTS[orientation],
      orientation,
      scale,
      unit: quantity.unit,
    };
    const layout = layOut(data, frame);
    const style = getComputedStyle(element);
    const token = (/** @type {string} */ name) => style.getPropertyValue(name).trim();
    const look = {
      colour: mapColours(context.store.status.colour, context.facts.get("colour")?.high_first),
      ink: token("--ink"),
      paper: token("--surface"),
      quiet: token("--quiet"),
      line: token("--edge"),
      rim: dark.matches ? token("--quiet") : "none",
      acceptable: quantity.acceptable,
    };
    svg.setAttribute("viewBox", `0 0 ${frame.width} ${frame.height}`);
    svg.setAttribute("width", String(frame.width));
    svg.setAttribute("height", String(frame.height));
    svg.setAttribute("aria-label", `Histogram of ${titled(quantity.name, quantity.unit)}`);
    hand.draw(layout, marks(layout, data, look));
    key.hidden = !data.beside;
    setText(
      key,
      data.beside ? `Bars: A. Line: B${data.beside.scaled ? ", as if it had as many cells" : ""}.` : "",
    );
    setText(caption, inWords(data, quantity));
    note.hidden = !data.not_finite;
    setText(
      note,
      data.not_finite
        ? `${data.not_finite.toLocaleString("en-GB")} values are not finite and are left out`
        : "",
    );
  }

  watch(
    context,
    { status: ["histogram", "colour", "filters.quality", "unit"], facts: ["histogram", "statistics"] },
    draw,
  );
  followSecond(context, ["histogram"], draw);
  new ResizeObserver(draw).observe(element);
  dark.addEventListener("change", draw);
  return element;
}

/** @param {import("../charts/histogram_layout.js").HistogramData} data @param {import("../state/quantity.js").Quantity} quantity */
function inWords(data, quantity) {
  const counts = Array.from(data.counts, Number);
  const peak = counts.indexOf(Math.max(...counts));
  const between = `${decimal(Number(data.edges[peak]))} and ${measured(Number(data.edges[peak + 1]), quantity.unit)}`;
  return `${quantity.name} from ${decimal(data.low)} to ${measured(data.high, quantity.unit)}; most values, ${counts[peak]}, lie between ${between}.`;
}
