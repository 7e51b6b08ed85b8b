import { categoryColour } from "../colours/palettes.js";
import { markColour } from "../colours/marks.js";
import { byOrigin, groupName, groupsInWords, groupsOf, originName } from "../state/groups.js";
import { count, counted, decimal } from "../state/numbers.js";
import { clear, dig, isClear, isolate, undig } from "../state/picking.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { swatch } from "../widgets/swatch.js";
import { interfaceTable } from "./interfaces.js";

/**
 * @typedef {import("../widgets/bind.js").Context} Context
 * @typedef {import("../state/answers.js").GroupRow} GroupRow
 * @typedef {import("../state/status.js").Status["filters"]["groups"]} Chosen
 */

/** @param {Context} context */
const chosenOf = ({ store }) => store.status.filters.groups;

/** @param {Context} context @param {Chosen} groups */
const choose = ({ store }, groups) => store.set({ filters: { groups } });

/** @param {Context} context */
const hasGroups = ({ facts }) => groupsOf(facts).length > 0;

/** @param {Context} context */
const originsOf = ({ facts }) => [...byOrigin(groupsOf(facts)).keys()];

/** @type {import("../widgets/section.js").Section} */
export const groups = {
  id: "groups",
  title: "Groups",
  digestOf: { facts: ["description"] },
  digest: ({ facts }) => groupsInWords(groupsOf(facts)),
  hidden: (context) => !hasGroups(context),
  hiddenOf: { facts: ["description"] },
  controls: [
    { kind: "custom", render: groupList },
    {
      kind: "choice",
      id: "interfaces",
      label: "Interfaces",
      hint: "Faces between two groups, drawn as a film",
      path: "marks.interfaces",
      facts: ["description"],
      hidden: (context) => !originsOf(context).length,
      options: (context) => [
        { value: "", name: "none" },
        ...originsOf(context).map((origin) => ({ value: origin, name: `of ${originName(origin)}` })),
      ],
    },
    { kind: "custom", render: interfaceTable },
    { kind: "custom", render: groupTable },
  ],
};

/** Every group, origin by origin: shown or not, alone, coloured; sets of nodes as points. @param {Context} context */
function groupList(context) {
  const element = h("div", { class: "group-list" });
  watch(
    context,
    {
      facts: ["description", "colour"],
      status: ["filters.groups", "colour.by", "colour.grouping", "marks.nodes"],
    },
    () => {
      const focused =
        document.activeElement instanceof HTMLElement ? document.activeElement.dataset.key : null;
      const scrolled = [...element.querySelectorAll("ul")].map((list) => list.scrollTop);
      const known = groupsOf(context.facts);
      const nodes = known.filter(({ kind }) => kind === "vertices");
      const parts = [...byOrigin(known)].map(([origin, some]) => originPart(context, origin, some));
      if (nodes.length) parts.push(nodePart(context, nodes));
      element.replaceChildren(...parts, showAll(context));
      [...element.querySelectorAll("ul")].forEach((list, k) => (list.scrollTop = scrolled[k] ?? 0));
      if (focused)
        /** @type {HTMLElement | null} */ (
          element.querySelector(`[data-key="${CSS.escape(focused)}"]`)
        )?.focus();
    },
  );
  return element;
}

/** @param {Context} context */
function showAll(context) {
  return h(
    "div",
    { class: "actions" },
    h(
      "button",
      {
        type: "button",
        class: "button",
        disabled: isClear(chosenOf(context)),
        "data-key": "all",
        onclick: () => choose(context, clear()),
      },
      "Show all",
    ),
  );
}

/** @param {Context} context @param {string} origin @param {readonly GroupRow[]} some */
function originPart(context, origin, some) {
  const colour = context.facts.get("colour");
  const by = context.store.status.colour.by;
  const coloured = by === "group" && colour?.quantity === `group:${origin}` ? colour : null;
  const colours = new Map((coloured?.groups ?? []).map((row) => [row.id, row.colour]));
  const button = h(
    "button",
    {
      type: "button",
      class: "link",
      "aria-pressed": String(coloured !== null),
      "data-key": `colour ${origin}`,
      onclick: () =>
        context.store.set({ colour: coloured ? { by: "sides" } : { by: "group", grouping: origin } }),
    },
    coloured ? "coloured" : "colour",
  );
  const rest = coloured && restInWords(coloured);
  return h(
    "section",
    { class: "group-part" },
    h("header", {}, h("h3", {}, originName(origin)), button),
    h("ul", { class: "parts" }, ...some.map((group) => row(context, group, colours.get(group.id)))),
    rest ? h("p", { class: "quiet" }, rest) : null,
  );
}

/** Cells that no colour, or not the only one, stands for. @param {import("../state/answers.js").Colour} colour */
function restInWords({ without = 0, in_several: several = 0 }) {
  const parts = [
    without ? `${counted(without, "cell")} in none: grey` : "",
    several ? `${counted(several, "cell")} in several: coloured by the smallest` : "",
  ];
  return parts.filter(Boolean).join("; ");
}

/** Whether a group is shown. @param {Chosen} chosen @param {string} id */
function isShown({ enabled, isolated, hidden, shown }, id) {
  return !enabled || shown.includes(id) || !(isolated || hidden.includes(id));
}

/** @param {Context} context @param {GroupRow} group @param {number | undefined} colour */
function row(context, group, colour) {
  const name = groupName(group);
  const box = h("input", {
    type: "checkbox",
    class: "row-switch",
    "aria-label": `${name} shown`,
    "data-key": `show ${group.id}`,
    onchange: () => choose(context, (box.checked ? undig : dig)(chosenOf(context), group.id)),
  });
  box.checked = isShown(chosenOf(context), group.id);
  const only = h(
    "button",
    {
      type: "button",
      class: "link",
      "aria-label": `Show ${name} only`,
      "data-key": `only ${group.id}`,
      onclick: () => {
        choose(context, isolate([group.id]));
        void context.app.views.flyToShown();
      },
    },
    "only",
  );
  return h(
    "li",
    {},
    h(
      "label",
      { class: "part-name", title: name },
      box,
      colour !== undefined && swatch(categoryColour("group", colour)),
      h("span", { class: "group-name" }, name),
    ),
    h("span", { class: "category-count" }, count(group.count)),
    only,
  );
}

/** Sets of nodes: drawn as points where they are chosen. @param {Context} context @param {readonly GroupRow[]} nodes */
function nodePart(context, nodes) {
  const { store } = context;
  const drawn = store.status.marks.nodes;
  const rows = nodes.map((group) => {
    const name = groupName(group);
    const box = h("input", {
      type: "checkbox",
      class: "row-switch",
      "aria-label": `Nodes of ${name} drawn`,
      "data-key": `nodes ${group.id}`,
      onchange: () => {
        const others = store.status.marks.nodes.filter((id) => id !== group.id);
        store.set({ marks: { nodes: box.checked ? [...others, group.id] : others } });
      },
    });
    const place = drawn.indexOf(group.id);
    box.checked = place >= 0;
    return h(
      "li",
      {},
      h(
        "label",
        { class: "part-name", title: name },
        box,
        place >= 0 && swatch(markColour(place % 6)),
        h("span", { class: "group-name" }, name),
      ),
      h("span", { class: "category-count" }, counted(group.count, "node")),
    );
  });
  return h(
    "section",
    { class: "group-part" },
    h("header", {}, h("h3", {}, "Sets of nodes, as points")),
    h("ul", { class: "parts" }, ...rows),
  );
}

/** Size and quality of each group of cells, measured when the table is unfolded. @param {Context} context */
function groupTable(context) {
  const body = h("tbody");
  const heads = ["Group", "Cells", "Invalid", "SJ min", "SJ mean", "Volume"];
  const table = h(
    "table",
    { class: "table group-table" },
    h("caption", { class: "visually-hidden" }, "Statistics of the groups of cells"),
    h("thead", {}, h("tr", {}, ...heads.map((name) => h("th", { scope: "col" }, name)))),
    body,
  );
  const element = h(
    "details",
    { class: "more", id: "group-statistics" },
    h("summary", { class: "more-head" }, "Statistics"),
    h(
      "div",
      { class: "group-scroll", tabindex: "0", role: "region", "aria-label": "Statistics of groups" },
      table,
    ),
  );
  const fill = () => {
    const known = groupsOf(context.facts).filter(({ kind }) => kind === "cells");
    element.hidden = !known.length;
    const measures = context.facts.get("groupMeasures");
    if (element.open && known.length && !measures) void context.app.grouped.measure();
    body.replaceChildren(
      ...known.map((group) => {
        const found = measures?.[group.id];
        const values = found
          ? [
              count(found.invalid),
              decimal(found.scaled_jacobian_min),
              decimal(found.scaled_jacobian_mean),
              decimal(found.volume),
            ]
          : ["…", "…", "…", "…"];
        return h(
          "tr",
          {},
          h("th", { scope: "row", title: groupName(group) }, groupName(group)),
          h("td", {}, count(group.count)),
          ...values.map((value, k) => h("td", k === 0 && found?.invalid ? { class: "outside" } : {}, value)),
        );
      }),
    );
  };
  element.addEventListener("toggle", fill);
  watch(context, { facts: ["description", "groupMeasures", "core"] }, fill);
  return element;
}
