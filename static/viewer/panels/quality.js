import { optionsOf } from "../state/choices.js";
import { clamp, count, decimal } from "../state/numbers.js";
import { watch } from "../widgets/bind.js";
import { wholeNumber } from "../widgets/controls.js";
import { h } from "../widgets/dom.js";
import { histogramPanel } from "./histogram.js";
import { worstCells } from "./worst_cells.js";
import { chooseQuantity, quantityOf, quantityOptions } from "../state/quantity.js";

/** @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../state/answers.js").Statistics} Statistics */

/** @type {readonly import("../widgets/bind.js").ChartFormat[]} */
const FORMATS = ["png", "svg", "pdf", "csv"];

/** @type {import("../widgets/section.js").Section} */
export const quality = {
  id: "quality",
  title: "Quality",
  open: true,
  controls: [
    {
      kind: "choice",
      id: "metric",
      label: "Metric",
      hint: "What is measured (S)",
      status: ["colour"],
      facts: ["summary"],
      options: quantityOptions,
      read: (context) => quantityOf(context).id,
      write: chooseQuantity,
    },
    { kind: "custom", render: variant },
    { kind: "custom", render: histogramPanel },
    { kind: "custom", render: digest },
    {
      kind: "more",
      id: "histogram-more",
      label: "Histogram",
      items: [
        {
          kind: "choice",
          id: "histogram-orientation",
          label: "Bars",
          path: "histogram.orientation",
          options: optionsOf("histogram.orientation"),
        },
        {
          kind: "choice",
          id: "histogram-scale",
          label: "Counts",
          path: "histogram.scale",
          options: optionsOf("histogram.scale"),
        },
        wholeNumber({
          id: "histogram-bins",
          label: "Bins",
          path: "histogram.bins",
          range: [10, 200, 10],
        }),
        {
          kind: "text",
          id: "histogram-title",
          label: "Title",
          hint: "metric and mesh",
          path: "histogram.title",
          read: ({ store }) => store.status.histogram.title,
          write: (title) => ({ histogram: { title } }),
        },
        {
          kind: "numbers",
          id: "histogram-size",
          label: "Size, mm",
          hint: "Of the saved one",
          status: ["histogram"],
          digits: 1,
          items: [millimetres("width"), millimetres("height")],
        },
        wholeNumber({
          id: "histogram-letters",
          label: "Letters",
          hint: "In points, of the saved one",
          path: "histogram.letters",
          range: [6, 24, 1],
        }),
        {
          kind: "choice",
          id: "histogram-font",
          label: "Font",
          path: "histogram.font",
          options: optionsOf("histogram.font"),
        },
        {
          kind: "actions",
          label: "Save as",
          facts: ["histogram"],
          items: FORMATS.map((format) => ({
            name: `Save the histogram as ${format.toUpperCase()}`,
            text: format.toUpperCase(),
            disabled: ({ facts }) => !facts.get("histogram"),
            press: ({ app }) => app.saveHistogram(format),
          })),
        },
      ],
    },
    {
      kind: "more",
      id: "statistics-more",
      label: "Statistics and worst cells",
      items: [
        { kind: "custom", render: statisticsTable },
        { kind: "custom", render: worstCells },
      ],
    },
  ],
};

/** @param {"width" | "height"} side @returns {import("../widgets/bind.js").NumberField} */
function millimetres(side) {
  return {
    name: side,
    read: ({ store }) => store.status.histogram[side],
    write: (value, { tables }) => {
      const [least, most] = tables.limits[`histogram.${side}`];
      return value === null ? null : { histogram: { [side]: clamp(value, least, most) } };
    },
  };
}

/** @param {Context} context @returns {Statistics | undefined} */
function statisticsOf(context) {
  return context.facts.get("statistics")[quantityOf(context).id];
}

/** @type {import("../widgets/bind.js").Dependencies} */
const WATCHED = { status: ["colour"], facts: ["statistics", "summary"] };

/** Which of the metrics it is that go by its name. @param {Context} context */
function variant(context) {
  const element = h("p", { class: "variant quiet" });
  watch(context, WATCHED, () => {
    element.textContent = quantityOf(context).variant;
    element.hidden = !element.textContent;
  });
  return element;
}

/** Minimum, mean and what lies outside the acceptable range, in one line under the histogram. @param {Context} context */
function digest(context) {
  const element = h("dl", { class: "digest-line" });
  watch(context, WATCHED, () => {
    const statistics = statisticsOf(context);
    element.hidden = !statistics;
    if (!statistics) return;
    const pairs = [
      ["min", decimal(statistics.min)],
      ["mean", decimal(statistics.mean)],
      ["max", decimal(statistics.max)],
    ];
    element.replaceChildren(
      ...pairs.map(([name, value]) => h("div", {}, h("dt", {}, name), h("dd", {}, value))),
    );
  });
  return element;
}

/** @param {readonly [number | null, number | null]} range */
function rangeInWords([low, high]) {
  return `${low === null ? "−∞" : decimal(low, 2)} to ${high === null ? "∞" : decimal(high, 2)}`;
}

/** @param {Statistics} statistics @param {import("../state/quantity.js").Quantity} quantity @returns {[string, string][]} */
function statisticsRows(statistics, quantity) {
  const { percentiles } = statistics;
  /** @type {[string, string][]} */
  const rows = [
    ["Minimum", decimal(statistics.min)],
    ["Maximum", decimal(statistics.max)],
    ["Mean", decimal(statistics.mean)],
    ["Median", decimal(statistics.median)],
    ["Variance", decimal(statistics.variance)],
    ["Percentiles 1, 5", `${decimal(percentiles["1"])}, ${decimal(percentiles["5"])}`],
    ["25, 75", `${decimal(percentiles["25"])}, ${decimal(percentiles["75"])}`],
    ["95, 99", `${decimal(percentiles["95"])}, ${decimal(percentiles["99"])}`],
  ];
  if (quantity.acceptable) {
    rows.push(
      ["Acceptable", rangeInWords(quantity.acceptable)],
      ["Outside it", count(statistics.outside_acceptable)],
    );
  }
  if (statistics.not_finite) rows.push(["Not finite", count(statistics.not_finite)]);
  return rows;
}

/** @param {Context} context */
function statisticsTable(context) {
  const body = h("tbody");
  const caption = h("caption", { class: "visually-hidden" });
  const element = h("table", { class: "table" }, caption, body);
  watch(context, WATCHED, () => {
    const statistics = statisticsOf(context);
    const quantity = quantityOf(context);
    caption.textContent = `Statistics of ${quantity.name}`;
    const rows = statistics ? statisticsRows(statistics, quantity) : [];
    body.replaceChildren(
      ...rows.map(([name, value]) => h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, value))),
    );
  });
  return element;
}
