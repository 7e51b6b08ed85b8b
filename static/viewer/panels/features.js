import { markColour } from "../colours/marks.js";
import { DIMENSIONS, FEATURE_NAMES, idOfFeature } from "../state/groups.js";
import { count, counted } from "../state/numbers.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { GroupRows } from "./group_rows.js";

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
  /** @type {unknown} */
  let known = null;
  /** @type {ReturnType<typeof part>[]} */
  let made = [];
  watch(context, { facts: ["description"], status: ["marks"] }, () => {
    const found = context.facts.get("description")?.features;
    if (found !== known) {
      known = found;
      made = DIMENSIONS.filter((name) => rowsOf(context, name)?.count).map((name) => part(context, name));
      element.hidden = !made.length;
      element.replaceChildren(...made.map((one) => one.element));
    }
    for (const one of made) one.update();
  });
  return element;
}

/** @param {Context} context @param {Dimension} name */
function part({ store, facts }, name) {
  const found = facts.get("description")?.features?.[name];
  const box = h("input", {
    type: "checkbox",
    class: "row-switch",
    "aria-label": `Feature ${name} drawn`,
    onchange: () => store.set({ marks: { [name]: box.checked } }),
  });
  const colours = new Map((found?.groups ?? []).map(({ id, colour }) => [id, colour]));
  const idOf = (/** @type {{ id: string }} */ group) => idOfFeature(name, group);
  const rows = new GroupRows(found?.groups ?? [], {
    label: `of the feature ${name} drawn`,
    turn: (group, on) => {
      const others = store.status.marks.hidden.filter((one) => one !== idOf(group));
      const marks = { hidden: on ? others : [...others, idOf(group)] };
      store.set({ marks: on && !store.status.marks[name] ? { ...marks, [name]: true } : marks });
    },
  });
  const element = h(
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
    rows.element,
    found?.lost ? h("p", { class: "outside" }, `${count(found.lost)} not in the mesh: drawn in red`) : null,
  );
  const update = () => {
    const { marks } = store.status;
    const hidden = new Set(marks.hidden);
    box.checked = marks[name];
    rows.update(
      (group) => marks[name] && !hidden.has(idOf(group)),
      ({ id }) => {
        const colour = colours.get(id) ?? null;
        return colour === null ? null : markColour(colour);
      },
    );
  };
  return { element, update };
}
