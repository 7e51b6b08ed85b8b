import { count, counted, decimal } from "../state/numbers.js";
import { metricOf } from "../state/tables.js";
import { measured, unitOf } from "../state/units.js";
import { chooseQuantity } from "../state/quantity.js";
import { watch } from "../widgets/bind.js";
import { h, setText } from "../widgets/dom.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

const DISPLACEMENT = "compare:displacement";

/** The metric that is looked at, or whose change is. @param {Context} context */
function metricAtHand({ store, tables }) {
  const { by, metric, attribute } = store.status.colour;
  const own =
    by === "attribute" && attribute.startsWith("change:") ? attribute.slice("change:".length) : metric;
  return metricOf(tables, own) ?? tables.metrics[0];
}

/**
 * Cells that are the same in both meshes, one by one: where the metric got worse, and how far vertices moved.
 *
 * @param {Context} context
 */
export function compareChanges(context) {
  const { app, facts, store } = context;
  const words = h("p", { role: "status" });
  const moved = h("p", { class: "quiet" });
  const colour = button("Colour by change", () => look(`change:${metricAtHand(context).id}`));
  const worse = button("Only what got worse", () => filter());
  const list = h("p", { class: "cell-list" });
  const arrows = button("Arrows", () => store.set({ arrows: { attribute: shows() ? "" : DISPLACEMENT } }));
  arrows.title = "The way of each vertex from A to B";
  const way = button("Colour by displacement", () => look(DISPLACEMENT));
  const element = h(
    "div",
    { class: "compare-part" },
    h("h3", { class: "compare-title" }, "Cell by cell"),
    words,
    list,
    h("div", { class: "actions" }, colour, worse),
    moved,
    h("div", { class: "actions" }, way, arrows),
  );
  const shows = () => store.status.arrows.attribute === DISPLACEMENT;
  const look = (/** @type {string} */ id) => {
    store.seal();
    const { by, attribute } = store.status.colour;
    const back = by === "attribute" && attribute === id;
    store.set(chooseQuantity(back ? metricAtHand(context).id : id, context));
  };
  const bandOf = (/** @type {string} */ quantity) =>
    store.status.filters.quality.items.find((item) => item.quantity === quantity);
  function filter() {
    const { id, better } = metricAtHand(context);
    const quantity = `change:${id}`;
    const others = store.status.filters.quality.items.filter((item) => item.quantity !== quantity);
    // A band of changes that ends at 0 leaves out what has not changed.
    const [minimum, maximum] = better === "high" ? [null, 0] : [0, null];
    const items = bandOf(quantity)
      ? others
      : [...others, { quantity, keep: /** @type {const} */ ("inside"), minimum, maximum }];
    store.seal();
    store.set({ filters: { quality: { enabled: true, items } } });
  }

  let asked = "";
  async function tell() {
    const told = facts.get("comparison");
    element.hidden = !told?.same_cells;
    if (!told?.same_cells) return;
    const metric = metricAtHand(context);
    const { displacement } = told;
    const unit = unitOf(store.status, 1);
    setText(
      moved,
      displacement
        ? `Vertices moved by ${measured(displacement.max, unit)} at most (${decimal(displacement.max_percent)} % of the diagonal), ${measured(displacement.mean, unit)} in the mean`
        : "",
    );
    press(
      colour,
      store.status.colour.by === "attribute" && store.status.colour.attribute === `change:${metric.id}`,
    );
    press(way, store.status.colour.by === "attribute" && store.status.colour.attribute === DISPLACEMENT);
    press(worse, Boolean(bandOf(`change:${metric.id}`)));
    press(arrows, shows());
    const key = `${metric.id} ${told.name}`;
    if (asked === key) return;
    asked = key;
    setText(words, `${metric.name}: …`);
    list.replaceChildren();
    const found = await app.comparing.changes(metric.id);
    if (asked !== key) return;
    if (!found) {
      asked = "";
      return;
    }
    const loss =
      found.worse && found.largest_loss !== null
        ? `, by ${measured(found.largest_loss, unitOf(store.status, metric.length_power))} at most`
        : "";
    setText(
      words,
      `${metric.name}: worse at ${counted(found.worse, "cell")}${loss}; better at ${count(found.better)}, the same at ${count(found.same)}`,
    );
    worse.disabled = !found.worse;
    list.replaceChildren(
      ...(found.cells.length ? [h("span", { class: "quiet" }, "Worst ")] : []),
      ...found.cells.map((number) =>
        h(
          "button",
          { type: "button", class: "link", onclick: () => void app.goTo("cell", number) },
          String(number),
        ),
      ),
    );
  }
  watch(
    context,
    { facts: ["comparison"], status: ["colour", "unit", "filters.quality", "arrows.attribute"] },
    () => void tell(),
  );
  facts.on("comparison", () => void (asked = ""));
  return element;
}

/** @param {string} text @param {() => void} press */
function button(text, press) {
  return h("button", { type: "button", class: "button", onclick: press }, text);
}

/** @param {HTMLButtonElement} button @param {boolean} on */
function press(button, on) {
  button.setAttribute("aria-pressed", String(on));
}
