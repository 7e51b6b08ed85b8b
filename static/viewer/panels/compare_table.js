import { decimal } from "../state/numbers.js";
import { quantityOf, chooseQuantity } from "../state/quantity.js";
import { followSecond } from "../state/second_facts.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";

/**
 * All metrics of both meshes and what the second has more, better ones marked by the metric's direction.
 *
 * @typedef {import("../widgets/bind.js").Context} Context
 * @typedef {"min" | "mean" | "max"} Statistic
 */

/** @type {readonly [Statistic, string][]} */
const STATISTICS = [
  ["min", "Minimum"],
  ["mean", "Mean"],
  ["max", "Maximum"],
];

/** @param {Context} context */
export function compareTable(context) {
  const { app, facts, tables } = context;
  const body = h("tbody");
  const chosen = h(
    "select",
    { class: "choice", "aria-label": "Which statistic of the metrics", onchange: () => show() },
    ...STATISTICS.map(([value, name]) => h("option", { value }, name)),
  );
  const all = h(
    "button",
    { type: "button", class: "button", onclick: () => void measureAll() },
    "All metrics",
  );
  const csv = h(
    "button",
    { type: "button", class: "button", onclick: () => app.comparing.saveTable() },
    "CSV",
  );
  const table = h(
    "table",
    { class: "table compare-table" },
    h("caption", { class: "visually-hidden" }, "Metrics of both meshes, and what the second has more"),
    h(
      "thead",
      {},
      h(
        "tr",
        {},
        h("th", { scope: "col" }, chosen),
        h("th", { scope: "col" }, "A"),
        h("th", { scope: "col" }, "B"),
        h("th", { scope: "col" }, "B − A"),
      ),
    ),
    body,
  );
  const element = h("div", { class: "compare-part" }, table, h("div", { class: "actions" }, all, csv));

  /** One after the other, so that a slice can come between. */
  async function measureAll() {
    all.disabled = true;
    try {
      const second = facts.get("second");
      for (const { id } of tables.metrics) {
        if (facts.get("second") !== second) return;
        await app.comparing.measure(id);
      }
    } finally {
      all.disabled = false;
    }
  }

  function show() {
    const second = facts.get("second");
    element.hidden = !second;
    if (!second) return;
    const [ours, theirs] = [facts, second].map((side) => side.get("statistics"));
    const statistic = /** @type {Statistic} */ (chosen.value);
    const looked = quantityOf(context).id;
    const rows = tables.metrics.filter(({ id }) => (ours[id] && theirs[id]) || id === looked);
    all.hidden = rows.length === tables.metrics.length;
    body.replaceChildren(
      ...rows.map((metric) => {
        const [a, b] = [ours[metric.id]?.[statistic], theirs[metric.id]?.[statistic]];
        const name = h(
          "button",
          {
            type: "button",
            class: "link",
            "aria-pressed": String(metric.id === looked),
            title: "Colour and plot by it",
            onclick: () => context.store.set(chooseQuantity(metric.id, context)),
          },
          metric.name,
        );
        return h(
          "tr",
          {},
          h("th", { scope: "row" }, name),
          h("td", {}, told(a)),
          h("td", {}, told(b)),
          difference(a, b, metric.better),
        );
      }),
    );
  }
  watch(context, { facts: ["second", "statistics", "histogram"], status: ["colour"] }, show);
  followSecond(context, ["statistics"], show);
  return element;
}

/** @param {number | null | undefined} value */
const told = (value) => (typeof value === "number" ? decimal(value) : "–");

/** What the second has more, with its sign, and whether that is better. @param {number | null | undefined} a @param {number | null | undefined} b @param {"high" | "low"} better */
export function difference(a, b, better) {
  if (typeof a !== "number" || typeof b !== "number") return h("td", {}, "–");
  const more = b - a;
  const gain = better === "high" ? more : -more;
  const word = gain > 0 ? "better" : gain < 0 ? "worse" : "";
  const text = `${more > 0 ? "+" : more < 0 ? "−" : ""}${decimal(Math.abs(more))}`;
  return h(
    "td",
    { class: word && `compare-${word}`, title: word },
    word ? h("span", { class: "compare-mark", "aria-hidden": "true" }, word === "better" ? "▲" : "▼") : null,
    text,
    word ? h("span", { class: "visually-hidden" }, ` ${word}`) : null,
  );
}
