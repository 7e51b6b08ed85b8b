import { markColour } from "../colours/marks.js";
import { DIMENSIONS, FEATURE_NAMES, groupName } from "../state/groups.js";
import { count, counted } from "../state/numbers.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { swatch } from "../widgets/swatch.js";

/** @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../state/groups.js").Dimension} Dimension */

/** An edge of the boundary whose faces differ by so much is none: the slider's right end. */
const OFF = 180;

/** @param {Context} context @param {Dimension} name */
const rowsOf = ({ facts }, name) => facts.get("description")?.features?.[name];

/** @type {import("../widgets/section.js").Section} */
export const features = {
  id: "features",
  title: "Features",
  digestOf: { facts: ["description", "marks"], status: ["marks.sharp_angle"] },
  digest: (context) => {
    const { sharp } = context.facts.get("marks");
    if (context.store.status.marks.sharp_angle < OFF && sharp !== undefined)
      return counted(sharp, "sharp edge");
    const words = DIMENSIONS.map((name) => {
      const number = rowsOf(context, name)?.count ?? 0;
      return number ? counted(number, ...FEATURE_NAMES[name]) : "";
    });
    return words.filter(Boolean).join(", ");
  },
  controls: [
    {
      kind: "slider",
      id: "sharp-angle",
      label: "Sharp edges",
      hint: "Edges of the boundary whose faces differ by more degrees; right end: none",
      path: "marks.sharp_angle",
      range: [0, OFF, 1],
      digits: 0,
    },
    { kind: "custom", render: featureList },
  ],
};

/** The file's corners, edges and faces: drawn or not, group by group. @param {Context} context */
function featureList(context) {
  const element = h("div", { class: "group-list" });
  watch(context, { facts: ["description"], status: ["marks"] }, () => {
    const focused = document.activeElement instanceof HTMLElement ? document.activeElement.dataset.key : null;
    const some = DIMENSIONS.filter((name) => rowsOf(context, name)?.count);
    element.hidden = !some.length;
    element.replaceChildren(...some.map((name) => part(context, name)));
    if (focused)
      /** @type {HTMLElement | null} */ (
        element.querySelector(`[data-key="${CSS.escape(focused)}"]`)
      )?.focus();
  });
  return element;
}

/** @param {Context} context @param {Dimension} name */
function part(context, name) {
  const { store } = context;
  const found = rowsOf(context, name);
  const box = h("input", {
    type: "checkbox",
    class: "row-switch",
    "aria-label": `Feature ${name} drawn`,
    "data-key": name,
    onchange: () => store.set({ marks: { [name]: box.checked } }),
  });
  box.checked = store.status.marks[name];
  const lost = found?.lost
    ? h("p", { class: "outside" }, `${count(found.lost)} not of the mesh: drawn in red`)
    : null;
  return h(
    "section",
    { class: "group-part" },
    h(
      "header",
      {},
      h(
        "label",
        { class: "part-name" },
        box,
        h("h3", {}, counted(found?.count ?? 0, ...FEATURE_NAMES[name])),
      ),
    ),
    h("ul", { class: "parts" }, ...(found?.groups ?? []).map((group) => row(context, name, group))),
    lost,
  );
}

/** @param {Context} context @param {Dimension} dimension @param {import("../state/answers.js").FeatureGroup} group */
function row(context, dimension, group) {
  const { store } = context;
  const id = `${dimension}:${group.id}`;
  const name = groupName(group);
  const box = h("input", {
    type: "checkbox",
    class: "row-switch",
    "aria-label": `${name} of the feature ${dimension} drawn`,
    "data-key": id,
    onchange: () => {
      const others = store.status.marks.hidden.filter((one) => one !== id);
      const marks = { hidden: box.checked ? others : [...others, id] };
      store.set({
        marks: box.checked && !store.status.marks[dimension] ? { ...marks, [dimension]: true } : marks,
      });
    },
  });
  box.checked = store.status.marks[dimension] && !store.status.marks.hidden.includes(id);
  return h(
    "li",
    {},
    h(
      "label",
      { class: "part-name", title: name },
      box,
      group.colour !== null && swatch(markColour(group.colour)),
      h("span", { class: "group-name" }, name),
    ),
    h("span", { class: "category-count" }, count(group.count)),
  );
}
