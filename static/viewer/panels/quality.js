import { optionsOf } from "../state/choices.js";
import { clamp, count, decimal } from "../state/numbers.js";
import { measured, unitOf, withUnit } from "../state/units.js";
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
const WATCHED = { status: ["colour", "unit"], facts: ["statistics", "summary"] };

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
    const { unit } = quantityOf(context);
    element.classList.toggle("digest-stacked", unit !== "");
    const pairs = [
      ["min", measured(statistics.min, unit)],
      ["mean", measured(statistics.mean, unit)],
      ["max", measured(statistics.max, unit)],
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

/** @param {Context} context @param {Statistics} statistics @returns {[string, string][]} */
function statisticsRows(context, statistics) {
  const { percentiles } = statistics;
  const { unit, lengthPower, acceptable } = quantityOf(context);
  const { status } = context.store;
  const two = (/** @type {string} */ low, /** @type {string} */ high) =>
    `${decimal(percentiles[low])}, ${measured(percentiles[high], unit)}`;
  /** @type {[string, string][]} */
  const rows = [
    ["Minimum", measured(statistics.min, unit)],
    ["Maximum", measured(statistics.max, unit)],
    ["Mean", measured(statistics.mean, unit)],
    ["Median", measured(statistics.median, unit)],
    ["Variance", measured(statistics.variance, unitOf(status, 2 * lengthPower))],
    ["Percentiles 1, 5", two("1", "5")],
    ["25, 75", two("25", "75")],
    ["95, 99", two("95", "99")],
  ];
  if (acceptable) {
    rows.push(
      ["Acceptable", withUnit(rangeInWords(acceptable), unit)],
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
    caption.textContent = `Statistics of ${quantityOf(context).name}`;
    const rows = statistics ? statisticsRows(context, statistics) : [];
    body.replaceChildren(
      ...rows.map(([name, value]) => h("tr", {}, h("th", { scope: "row" }, name), h("td", {}, value))),
    );
  });
  return element;
}
