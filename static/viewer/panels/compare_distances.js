import { count, decimal } from "../state/numbers.js";
import { chooseQuantity } from "../state/quantity.js";
import { measured, unitOf } from "../state/units.js";
import { watch } from "../widgets/bind.js";
import { h, setText } from "../widgets/dom.js";

/** @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../state/answers.js").DistanceFacts} DistanceFacts */

const DISTANCE = "compare:distance";

/** @type {readonly [name: string, part: "max" | "mean" | "rms"][]} */
const ROWS = [
  ["Largest", "max"],
  ["Mean", "mean"],
  ["Root mean square", "rms"],
];

/**
 * How far the two surfaces are apart (SPEC S7), both ways; measured when it is asked for.
 *
 * @param {Context} context
 */
export function compareDistances(context) {
  const { app, facts, store } = context;
  const body = h("tbody");
  const table = h(
    "table",
    { class: "table" },
    h("caption", { class: "visually-hidden" }, "Distances between the two surfaces"),
    h(
      "thead",
      {},
      h("tr", {}, h("td"), h("th", { scope: "col" }, "A to B"), h("th", { scope: "col" }, "B to A")),
    ),
    body,
  );
  const bar = h("progress", { class: "tracing-bar", max: 1, "aria-label": "Measuring distances" });
  const whole = h("p");
  const volumes = h("p", { class: "quiet" });
  const button = (/** @type {string} */ text, /** @type {() => void} */ press) =>
    h("button", { type: "button", class: "button", onclick: press }, text);
  const measure = button("Measure", () => void app.comparing.distances.measure());
  const colour = button("Colour by distance", () => {
    const { by, attribute, metric } = store.status.colour;
    store.seal();
    const on = by === "attribute" && attribute === DISTANCE;
    store.set(chooseQuantity(on ? metric : DISTANCE, context));
  });
  const csv = button("CSV", () => void app.comparing.distances.save());
  csv.title = "The distance of every vertex of A's boundary";
  const element = h(
    "div",
    { class: "compare-part" },
    h("h3", { class: "compare-title" }, "Distance of the surfaces"),
    table,
    whole,
    volumes,
    bar,
    h("div", { class: "actions" }, measure, colour, csv),
  );
  watch(context, { facts: ["comparison", "apart", "measuring"], status: ["unit", "colour"] }, () => {
    const told = facts.get("comparison");
    element.hidden = !told;
    if (!told) return;
    const apart = facts.get("apart");
    const measuring = facts.get("measuring");
    const unit = unitOf(store.status, 1);
    bar.hidden = !measuring;
    bar.value = measuring?.of ? measuring.done / measuring.of : 0;
    measure.hidden = apart !== null;
    measure.disabled = measuring !== null;
    table.hidden = whole.hidden = !apart;
    const on = store.status.colour.by === "attribute" && store.status.colour.attribute === DISTANCE;
    colour.setAttribute("aria-pressed", String(on));
    setText(
      volumes,
      told.volume_ratio === null ? "" : `Volume of B: ${decimal(100 * told.volume_ratio)} % of A's`,
    );
    volumes.hidden = !volumes.textContent;
    if (!apart) return;
    const row = (/** @type {string} */ name, /** @type {(way: DistanceFacts) => string} */ tell) =>
      h(
        "tr",
        {},
        h("th", { scope: "row" }, name),
        h("td", {}, tell(apart.a_to_b)),
        h("td", {}, tell(apart.b_to_a)),
      );
    body.replaceChildren(
      ...ROWS.flatMap(([name, part]) => [
        row(name, (way) => measured(way[part], unit)),
        row("% of the diagonal", (way) => decimal(way[`${part}_percent`])),
      ]),
      row("Vertices", (way) => count(way.vertices)),
    );
    setText(
      whole,
      `Hausdorff: ${measured(apart.hausdorff, unit)}, ${decimal(apart.hausdorff_percent)} % of the diagonal`,
    );
    whole.title =
      "The larger of both largest distances, of vertices to the other surface; percents are of A's diagonal";
  });
  return element;
}
