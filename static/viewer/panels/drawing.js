import { categoryColour } from "../colours/palettes.js";
import { optionsOf } from "../state/choices.js";
import { byOrigin, groupingOf, groupKeys, groupName, groupsOf, originName } from "../state/groups.js";
import { count, typed } from "../state/numbers.js";
import { chosenKeys } from "../state/structure.js";
import { watch } from "../widgets/bind.js";
import { wholeNumber } from "../widgets/controls.js";
import { h } from "../widgets/dom.js";
import { arrows } from "./arrows.js";
import { swatch } from "../widgets/swatch.js";
import { KIND_NAMES, KINDS } from "../state/kinds.js";

/** @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../state/status.js").Status} Status */

/** The slider of each separation mode: which setting it moves. @type {Record<string, { path: string, name: string, range: readonly [number, number, number] }>} */
const SEPARATION_SLIDERS = {
  lines: { path: "line_opacity", name: "Darkness", range: [0, 1, 0.01] },
  darkness_coded_edges: { path: "line_opacity", name: "Darkness", range: [0, 1, 0.01] },
  fissure: { path: "gap", name: "Gap", range: [0.04, 0.2, 0.005] },
  rounded: { path: "radius", name: "Radius", range: [0.04, 0.2, 0.005] },
};

/** @param {string} setting @returns {import("../widgets/bind.js").Control} */
function separationSlider(setting) {
  const modes = Object.keys(SEPARATION_SLIDERS).filter((mode) => SEPARATION_SLIDERS[mode].path === setting);
  const { name, range } = SEPARATION_SLIDERS[modes[0]];
  return {
    kind: "slider",
    id: `separation-${setting}`,
    label: name,
    path: `separation.${setting}`,
    status: ["separation.mode"],
    range,
    hidden: ({ store }) => !modes.includes(store.status.separation.mode),
  };
}

/** @param {Context} context */
const colouredBy = ({ store }) => store.status.colour.by;

const waysOf = optionsOf("colour.by");

/** @param {Context} context */
const hasAttributes = (context) =>
  Boolean(context.facts.get("summary")?.attributes?.length) || colouredBy(context) === "attribute";

/** Whether the mesh has what a way of colouring shows. @param {Context} context @param {Status["colour"]["by"]} way */
function hasWhat(context, way) {
  if (way === "attribute") return hasAttributes(context);
  if (way === "chosen")
    return colouredBy(context) === "chosen" || chosenKeys(context.store.status.structure).length > 0;
  if (way === "group") return colouredBy(context) === "group" || byOrigin(groupsOf(context.facts)).size > 0;
  return true;
}

/** @type {import("../widgets/section.js").Section} */
export const drawing = {
  id: "drawing",
  title: "Drawing",
  open: true,
  controls: [
    {
      kind: "choice",
      id: "separation",
      label: "Separation",
      hint: "How cells are told apart (E)",
      path: "separation.mode",
      options: optionsOf("separation.mode"),
    },
    separationSlider("line_opacity"),
    separationSlider("gap"),
    separationSlider("radius"),
    {
      kind: "choice",
      id: "colour-by",
      label: "Colour",
      hint: "What the faces are coloured by (C)",
      path: "colour.by",
      status: ["structure"],
      facts: ["summary", "description"],
      options: (context) => waysOf(context).filter(({ value }) => hasWhat(context, value)),
      write: (by, { facts, store }) => {
        const first = facts.get("summary")?.attributes?.[0]?.id ?? "";
        return {
          colour: {
            by: /** @type {Status["colour"]["by"]} */ (by),
            ...(by === "attribute" && !store.status.colour.attribute ? { attribute: first } : {}),
          },
        };
      },
    },
    { kind: "custom", render: kindLegend },
    {
      kind: "choice",
      id: "colour-grouping",
      label: "Groups",
      path: "colour.grouping",
      status: ["colour.by"],
      facts: ["description"],
      read: groupingOf,
      write: (grouping) => ({ colour: { grouping } }),
      options: ({ facts }) =>
        [...byOrigin(groupsOf(facts)).keys()].map((value) => ({ value, name: originName(value) })),
      hidden: (context) => colouredBy(context) !== "group",
    },
    { kind: "custom", render: groupLegend },
    { kind: "custom", render: chosenLegend },
    {
      kind: "colours",
      label: "",
      status: ["colour.by"],
      items: [
        { path: "colour.outside", name: "Outside" },
        { path: "colour.inside", name: "Inside" },
      ],
      hidden: (context) => colouredBy(context) !== "sides",
    },
    {
      kind: "choice",
      id: "colour-map",
      label: "Map",
      path: "colour.map",
      status: ["colour.by"],
      options: optionsOf("colour.map"),
      hidden: (context) => !["quality", "attribute"].includes(colouredBy(context)),
      more: [
        {
          kind: "numbers",
          id: "colour-range",
          label: "Range",
          hint: "Values at the ends of the map; empty: the mesh's own",
          status: ["colour.by", "colour.range"],
          facts: ["colour"],
          items: [rangeField(0, "low"), rangeField(1, "high")],
        },
        { kind: "toggle", id: "colour-reversed", label: "Reversed", path: "colour.reversed" },
        wholeNumber({
          id: "colour-steps",
          label: "Steps",
          hint: "Colours of the map; 0: it runs smoothly",
          path: "colour.steps",
          range: [0, 16, 1],
        }),
        {
          kind: "colours",
          label: "Not finite",
          items: [{ path: "colour.missing", name: "Cells without a finite value" }],
        },
        {
          kind: "toggle",
          id: "colour-beyond",
          label: "Mark beyond",
          hint: "Values above and below the range that was set have colours of their own",
          path: "colour.beyond",
          status: ["colour.range"],
          why: ({ store }) => (store.status.colour.range ? "" : "no range was set"),
        },
        {
          kind: "colours",
          label: "",
          status: ["colour.beyond"],
          items: [
            { path: "colour.above", name: "Above" },
            { path: "colour.below", name: "Below" },
          ],
          hidden: ({ store }) => !store.status.colour.beyond,
        },
      ],
    },
    ...arrows,
  ],
};

/** One end of the colour map's range. @param {0 | 1} end @param {string} name @returns {import("../widgets/bind.js").NumberField} */
function rangeField(end, name) {
  /** @param {Context} context @returns {[number, number]} */
  const own = ({ facts }) => {
    const colour = facts.get("colour");
    return [colour?.low ?? 0, colour?.high ?? 1];
  };
  return {
    name,
    optional: true,
    placeholder: (context) => typed(own(context)[end]),
    read: ({ store }) => store.status.colour.range?.[end] ?? null,
    write: (value, context) => {
      if (value === null) return { colour: { range: null } };
      const [low, high] = context.store.status.colour.range ?? own(context);
      /** @type {[number, number]} */
      const range = end === 0 ? [value, high] : [low, value];
      return range[0] < range[1] ? { colour: { range } } : null;
    },
  };
}

/** Which colour is which kind of cell, and how many there are. @param {Context} context */
function kindLegend(context) {
  const element = h("ul", { class: "categories", "aria-label": "Colours of the kinds of cells" });
  watch(context, { status: ["colour.by"], facts: ["description", "summary"] }, () => {
    const counts = context.facts.get("description")?.shapes ?? context.facts.get("summary")?.kinds ?? {};
    element.hidden = colouredBy(context) !== "kind";
    element.replaceChildren(
      ...KINDS.filter((kind) => counts[kind]).map((kind) =>
        legendRow(
          categoryColour("kind", KINDS.indexOf(kind)),
          KIND_NAMES[kind][counts[kind] === 1 ? 0 : 1],
          counts[kind],
        ),
      ),
    );
  });
  return element;
}

/** Groups that the legend in the panel names; the section of groups has all. */
const MOST_KEYS = 12;

/** Which colour is which group. @param {Context} context */
function groupLegend(context) {
  const element = h("ul", { class: "categories", "aria-label": "Colours of the groups" });
  watch(context, { status: ["colour"], facts: ["colour", "description"] }, () => {
    const { by, missing } = context.store.status.colour;
    const colour = context.facts.get("colour");
    element.hidden = by !== "group" || !colour?.groups;
    if (element.hidden) return element.replaceChildren();
    const { keys, more } = groupKeys(colour, groupsOf(context.facts), MOST_KEYS);
    element.replaceChildren(
      ...keys.map((key) =>
        legendRow(categoryColour("group", key.colour), groupName(key.group), key.group.count),
      ),
      ...(more ? [h("li", { class: "quiet" }, `and ${count(more)} more`)] : []),
      ...(colour?.without ? [legendRow(missing, "in none", colour.without)] : []),
    );
  });
  return element;
}

/** Which colour is which sheet, chord or block of those that were chosen. @param {Context} context */
function chosenLegend(context) {
  const element = h("ul", { class: "categories", "aria-label": "Colours of what is chosen" });
  watch(context, { status: ["colour.by", "structure"] }, () => {
    const keys = colouredBy(context) === "chosen" ? chosenKeys(context.store.status.structure) : [];
    element.hidden = !keys.length;
    element.replaceChildren(...keys.map(({ colour, name }) => legendRow(colour, name)));
  });
  return element;
}

/** @param {string} colour @param {string} name @param {number} [number] of cells */
function legendRow(colour, name, number) {
  return h(
    "li",
    {},
    swatch(colour),
    h("span", { class: "category-name", title: name }, name),
    number === undefined ? null : h("span", { class: "category-count" }, count(number)),
  );
}
