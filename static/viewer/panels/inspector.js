import { decimal } from "../state/numbers.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/**
 * The cell that was clicked (SPEC V7): number, kind, corners, neighbours, every metric, attributes.
 *
 * @param {Context} context
 */
export function inspector(context) {
  const heading = h("h2", { id: "inspector-title" });
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
  watch(context, { facts: ["cell"] }, () => {
    const cell = context.facts.get("cell");
    element.hidden = !cell;
    if (!cell) return;
    heading.textContent = `Cell ${cell.cell}`;
    body.replaceChildren(...parts(context, cell));
  });
  return element;
}

/** @param {Context} context @param {any} cell */
function parts(context, cell) {
  const { tables, app } = context;
  const neighbours = [...cell.neighbours].filter((other) => other >= 0);
  const metrics = tables.metrics
    .filter(({ id }) => cell.metrics[id] !== undefined)
    .map(({ id, name, acceptable_range: range }) => metricRow(name, cell.metrics[id], range));
  const attributes = Object.entries(cell.attributes ?? {}).map(([name, value]) =>
    metricRow(name, value, null),
  );
  return [
    h("p", { class: "quiet" }, [cell.kind, validityInWords(cell.validity)].filter(Boolean).join(", ")),
    h(
      "div",
      { class: "actions" },
      h("button", { type: "button", class: "button", onclick: () => app.flyTo(cell.cell) }, "Fly to"),
      h("button", { type: "button", class: "button", onclick: () => app.pick("dig", cell.cell) }, "Hide"),
      h(
        "button",
        { type: "button", class: "button", onclick: () => app.pick("isolate", cell.cell) },
        "Isolate",
      ),
    ),
    table("Quality", metrics),
    attributes.length ? table("Attributes", attributes) : null,
    cornersTable(cell),
    h(
      "p",
      { class: "cell-list" },
      h("span", { class: "quiet" }, "Neighbours "),
      ...neighbours.map((other) =>
        h("button", { type: "button", class: "link", onclick: () => app.inspect(other) }, String(other)),
      ),
    ),
  ].filter((part) => part !== null);
}

/** @param {unknown} validity */
function validityInWords(validity) {
  if (typeof validity === "string") return validity;
  if (typeof validity === "number") return ["invalid", "valid", "validity undecided"][validity] ?? "";
  return "";
}

/** @param {string} name @param {any} value @param {readonly [number | null, number | null] | null} range */
function metricRow(name, value, range) {
  const outside =
    range &&
    typeof value === "number" &&
    ((range[0] !== null && value < range[0]) || (range[1] !== null && value > range[1]));
  const shown =
    typeof value === "number"
      ? decimal(value)
      : Array.isArray(value) || ArrayBuffer.isView(value)
        ? Array.from(/** @type {any} */ (value), (x) => decimal(Number(x))).join(", ")
        : String(value ?? "–");
  const cell = h(
    "td",
    outside ? { class: "outside", title: "outside the acceptable range" } : {},
    shown,
    outside ? h("span", { class: "visually-hidden" }, " outside the acceptable range") : null,
  );
  return h("tr", {}, h("th", { scope: "row" }, name), cell);
}

/** @param {string} caption @param {HTMLElement[]} rows */
function table(caption, rows) {
  return h("table", { class: "table" }, h("caption", {}, caption), h("tbody", {}, ...rows));
}

/** @param {any} cell */
function cornersTable(cell) {
  const corners = Array.from(/** @type {ArrayLike<number>} */ (cell.corners));
  const at = (/** @type {number} */ corner) => {
    const own = cell.coordinates[corner] ?? cell.coordinates.slice?.(corner * 3, corner * 3 + 3) ?? [];
    const flat = typeof own === "number" ? cell.coordinates.slice(corner * 3, corner * 3 + 3) : own;
    return Array.from(/** @type {ArrayLike<number>} */ (flat), (x) => decimal(x)).join(" ");
  };
  return table(
    "Corners",
    corners.map((id, corner) => h("tr", {}, h("th", { scope: "row" }, String(id)), h("td", {}, at(corner)))),
  );
}
