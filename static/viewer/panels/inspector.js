import { groupName, groupsOf } from "../state/groups.js";
import { decimal } from "../state/numbers.js";
import { isOutside } from "../state/quantity.js";
import { measured, titled, unitOf } from "../state/units.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";
import { structureOfCell } from "./cell_structure.js";

/** @typedef {import("../widgets/bind.js").MeshContext} Context @typedef {import("../state/answers.js").Inspection} Inspection */

/**
 * The cell that was clicked (SPEC V7): number, kind, corners, neighbours, every metric, attributes.
 *
 * @param {Context} context @param {string} [id] of its heading
 */
export function inspector(context, id = "inspector-title") {
  const heading = h("h2", { id });
  const close = h(
    "button",
    {
      type: "button",
      class: "button button-icon plain",
      "aria-label": "Close the inspector",
      onclick: () => context.app.inspect(null),
    },
    icon("clear"),
  );
  const body = h("div", { class: "inspector-body" });
  const element = h(
    "aside",
    { class: "inspector", "aria-labelledby": heading.id, hidden: true },
    h("header", {}, heading, close),
    body,
  );
  watch(context, { status: ["unit"], facts: ["cell"] }, () => {
    const cell = context.facts.get("cell");
    element.hidden = !cell;
    if (!cell) return;
    heading.textContent = `Cell ${cell.number}`;
    body.replaceChildren(...parts(context, cell));
  });
  return element;
}

/** @param {Context} context @param {Inspection} cell */
function parts(context, cell) {
  const { tables, app, store, facts } = context;
  const neighbours = cell.neighbours.filter((other) => other >= 0);
  const metrics = tables.metrics
    .filter(({ id }) => cell.metrics[id] !== undefined)
    .map(({ id, name, variant, acceptable_range: range, length_power: power }) =>
      metricRow(name, cell.pending.includes(id) ? "…" : cell.metrics[id], {
        range,
        variant,
        unit: unitOf(store.status, power),
      }),
    );
  const attributes = Object.entries(cell.attributes).map(([name, value]) => metricRow(name, value));
  return [
    h("p", { class: "quiet" }, `${cell.kind}, ${cell.validity}`),
    h(
      "div",
      { class: "actions" },
      h("button", { type: "button", class: "button", onclick: () => app.flyTo(cell.cell) }, "Fly to"),
      h("button", { type: "button", class: "button", onclick: () => app.cutTo(cell.cell) }, "Cut to it"),
      h("button", { type: "button", class: "button", onclick: () => app.pick("dig", cell.cell) }, "Hide"),
      h(
        "button",
        { type: "button", class: "button", onclick: () => app.pick("isolate", cell.cell) },
        "Isolate",
      ),
    ),
    cell.groups.length ? groupsOfCell(context, cell) : null,
    structureOfCell(context, cell),
    table("Quality", metrics),
    attributes.length ? table("Attributes", attributes) : null,
    cornersTable(cell, unitOf(store.status, 1)),
    h(
      "p",
      { class: "cell-list" },
      h("span", { class: "quiet" }, "Neighbours "),
      ...neighbours.map((other) =>
        h(
          "button",
          { type: "button", class: "link", onclick: () => app.inspect(other) },
          String(facts.get("numbering").of(other)),
        ),
      ),
    ),
  ].filter((part) => part !== null);
}

/**
 * @param {string} name @param {unknown} value
 * @param {{ range?: readonly [number | null, number | null] | null, variant?: string, unit?: string }} [metric] what an attribute has not
 */
function metricRow(name, value, { range = null, variant = "", unit = "" } = {}) {
  const outside = range && typeof value === "number" && isOutside(value, range);
  const text =
    typeof value === "number"
      ? measured(value, unit)
      : Array.isArray(value)
        ? value.map((x) => decimal(Number(x))).join(", ")
        : String(value ?? "–");
  const cell = h(
    "td",
    outside ? { class: "outside", title: "outside the acceptable range" } : {},
    text,
    outside ? h("span", { class: "visually-hidden" }, " outside the acceptable range") : null,
  );
  return h("tr", {}, h("th", { scope: "row", ...(variant ? { title: variant } : {}) }, name), cell);
}

/** The groups that a cell is in. @param {Context} context @param {Inspection} cell */
function groupsOfCell({ facts }, { groups }) {
  const known = new Map(groupsOf(facts).map((group) => [group.id, groupName(group)]));
  return h(
    "p",
    { class: "cell-list" },
    h("span", { class: "quiet" }, "Groups "),
    groups.map((id) => known.get(id) ?? id).join(", "),
  );
}

/** @param {string} caption @param {HTMLElement[]} rows */
function table(caption, rows) {
  return h("table", { class: "table" }, h("caption", {}, caption), h("tbody", {}, ...rows));
}

/** @param {Inspection} cell @param {string} unit of the coordinates; may be empty */
function cornersTable({ nodes, coordinates }, unit) {
  const at = (/** @type {number} */ corner) => coordinates[corner].map((x) => decimal(x)).join(" ");
  return table(
    titled("Corners", unit),
    nodes.map((id, corner) => h("tr", {}, h("th", { scope: "row" }, String(id)), h("td", {}, at(corner)))),
  );
}
