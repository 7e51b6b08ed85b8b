import { count } from "../state/numbers.js";
import { watch } from "../widgets/bind.js";
import { h, setText } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";

/**
 * What stands around two pictures: the name of each mesh, and the line where they meet, to be dragged.
 *
 * @typedef {import("../widgets/bind.js").Context} Context
 */

/** Part of the view that one step of the keyboard moves the line by. */
const STEP = 0.02;

/** How near to the edges the line may come. */
const RIM = 0.04;

/** @param {Context} context */
export function compareView(context) {
  const view = /** @type {HTMLElement} */ (document.getElementById("view"));
  const pane = /** @type {HTMLElement} */ (document.getElementById("pane"));
  const [first, second] = [nameOf("A"), nameOf("B")];
  const line = divider(context, view);
  const { facts, store, app } = context;
  second.element.append(
    button("swap", "Swap", "Each mesh takes the place of the other", () => void app.comparing.swap()),
    button("clear", "Close the second mesh", "", () => app.comparing.close()),
  );
  const show = () => {
    const other = facts.get("second");
    const { layout, divider: at } = store.status.compare;
    view.classList.toggle("view-two", other !== null);
    view.dataset.layout = other ? layout : "";
    view.style.setProperty("--divider", `${100 * at}%`);
    line.hidden = !other;
    line.setAttribute("aria-valuenow", String(Math.round(100 * at)));
    first.show(other ? facts : null);
    second.show(other);
  };
  watch(context, { facts: ["second", "summary"], status: ["compare.layout", "compare.divider"] }, () => {
    const other = facts.get("second");
    const pane = document.getElementById("second-pane");
    if (other && pane && !pane.contains(second.element)) {
      pane.prepend(second.element);
      other.on("summary", show);
    }
    show();
  });
  pane.prepend(first.element);
  view.append(line);
}

/** The bar over a picture. @param {string} letter */
function nameOf(letter) {
  const name = h("span", { class: "pane-mesh" });
  const cells = h("span", { class: "quiet pane-cells" });
  const element = h(
    "div",
    { class: "pane-name", hidden: true },
    h("span", { class: "pane-letter" }, letter),
    name,
    cells,
  );
  return {
    element,
    /** @param {import("../state/facts.js").Facts | null} facts */
    show(facts) {
      const summary = facts?.get("summary");
      element.hidden = !facts;
      const told = facts?.get("entry")?.mesh.name ?? summary?.name ?? "";
      setText(name, told);
      name.title = told;
      setText(cells, summary ? count(summary.cells) : "");
    },
  };
}

/** @param {string} name @param {string} label @param {string} hint @param {() => void} press */
function button(name, label, hint, press) {
  return h(
    "button",
    {
      type: "button",
      class: "button button-icon plain",
      "aria-label": label,
      title: hint || label,
      onclick: press,
    },
    icon(name),
  );
}

/** @param {Context} context @param {HTMLElement} view */
function divider({ store }, view) {
  const move = (/** @type {number} */ at) =>
    store.set({ compare: { divider: Math.min(1 - RIM, Math.max(RIM, at)) } }, { undo: "divider" });
  const element = h("div", {
    class: "divider",
    role: "separator",
    tabindex: 0,
    "aria-orientation": "vertical",
    "aria-label": "Where the two pictures meet",
    "aria-valuemin": Math.round(100 * RIM),
    "aria-valuemax": Math.round(100 * (1 - RIM)),
    hidden: true,
    onpointerdown: (/** @type {PointerEvent} */ event) => {
      element.setPointerCapture(event.pointerId);
      event.preventDefault();
      element.focus();
    },
    onpointermove: (/** @type {PointerEvent} */ event) => {
      if (!element.hasPointerCapture(event.pointerId)) return;
      const { left, width } = view.getBoundingClientRect();
      move((event.clientX - left) / width);
    },
    onpointerup: () => store.seal(),
    ondblclick: () => {
      move(store.defaults.compare.divider);
      store.seal();
    },
    onkeydown: (/** @type {KeyboardEvent} */ event) => {
      const step = { ArrowLeft: -STEP, ArrowRight: STEP }[event.key];
      if (!step) return;
      event.preventDefault();
      event.stopPropagation();
      move(store.status.compare.divider + step);
    },
  });
  return element;
}
