import { FLIGHT } from "../app/views.js";
import { markColour } from "../colours/marks.js";
import { byOrigin, groupsInWords, groupsOf, originName } from "../state/groups.js";
import { counted } from "../state/numbers.js";
import { clear, dig, isClear, isolate, undig } from "../state/picking.js";
import { watch } from "../widgets/bind.js";
import { h, setAttribute, setText } from "../widgets/dom.js";
import { groupColour, GroupRows } from "./group_rows.js";
import { groupTable } from "./group_table.js";
import { interfaceTable } from "./interfaces.js";

/**
 * @typedef {import("../widgets/bind.js").Context} Context
 * @typedef {import("../state/answers.js").GroupRow} GroupRow
 * @typedef {import("../state/status.js").Status["filters"]["groups"]} Chosen
 *
 * @typedef {object} Part  the groups of one origin
 * @property {HTMLElement} element
 * @property {GroupRows} rows
 * @property {() => void} update
 */

/** Of so many groups one is found without a field to find it. */
const FEW = 20;

/** @param {Context} context */
const chosenOf = ({ store }) => store.status.filters.groups;

/** @param {Context} context @param {Chosen} groups */
const choose = ({ store }, groups) => store.set({ filters: { groups } });

/** @param {Context} context */
const originsOf = ({ facts }) => [...byOrigin(groupsOf(facts)).keys()];

/** @type {import("../widgets/section.js").Section} */
export const groups = {
  id: "groups",
  title: "Groups",
  digestOf: { facts: ["description"] },
  digest: ({ facts }) => groupsInWords(groupsOf(facts)),
  hidden: ({ facts }) => !groupsOf(facts).length,
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
  const find = h("input", {
    type: "search",
    class: "text",
    id: "find-group",
    autocomplete: "off",
    spellcheck: "false",
    placeholder: "Find a group",
    "aria-label": "Find a group by its name",
    oninput: () => narrow(),
  });
  const none = h("p", { class: "quiet", role: "status" });
  const all = h(
    "button",
    { type: "button", class: "button", onclick: () => choose(context, clear()) },
    "Show all",
  );
  const actions = h("div", { class: "actions" }, all);
  const parts = h("div");
  const element = h("div", { class: "group-list" }, find, none, parts);
  /** @type {readonly GroupRow[] | null} */
  let known = null;
  /** @type {Part[]} */
  let made = [];
  const narrow = () => {
    const left = made.map(({ element: part, rows }) => {
      const found = rows.find(find.value);
      part.hidden = !found;
      return found;
    });
    setText(
      none,
      made.length && !left.some(Boolean) ? `No group has “${find.value.trim()}” in its name.` : "",
    );
  };
  const make = () => {
    const nodes = groupsOf(context.facts).filter(({ kind }) => kind === "vertices");
    const some = [...byOrigin(groupsOf(context.facts))].map(([origin, of]) =>
      originPart(context, origin, of),
    );
    const last = nodes.length ? [nodePart(context, nodes)] : [];
    actions.hidden = !some.length;
    find.hidden = groupsOf(context.facts).length <= FEW;
    find.value = "";
    made = [...some, ...last];
    parts.replaceChildren(...some.map((part) => part.element), actions, ...last.map((part) => part.element));
    narrow();
  };
  watch(
    context,
    {
      facts: ["description", "colour"],
      status: ["filters.groups", "colour.by", "colour.grouping", "marks.nodes"],
    },
    () => {
      if (known !== groupsOf(context.facts)) {
        known = groupsOf(context.facts);
        make();
      }
      for (const part of made) part.update();
      all.disabled = isClear(chosenOf(context));
    },
  );
  return element;
}

/** @param {Context} context @param {string} origin @param {readonly GroupRow[]} some @returns {Part} */
function originPart(context, origin, some) {
  const { facts, store } = context;
  const name = originName(origin);
  const colouring = () => {
    const colour = facts.get("colour");
    return store.status.colour.by === "group" && colour?.quantity === `group:${origin}` ? colour : null;
  };
  const button = h(
    "button",
    {
      type: "button",
      class: "button",
      "aria-label": `Colour by ${name}`,
      onclick: () => store.set({ colour: colouring() ? { by: "sides" } : { by: "group", grouping: origin } }),
    },
    "Colour",
  );
  const rows = new GroupRows(some, {
    label: "shown",
    turn: ({ id }, on) => choose(context, (on ? undig : dig)(chosenOf(context), id)),
    only: ({ id }) => {
      store.seal();
      store.set({ filters: { groups: isolate([id]) } }, { undo: FLIGHT });
      void context.app.views.flyToShown();
    },
  });
  const rest = h("p", { class: "quiet" });
  const element = h(
    "section",
    { class: "group-part" },
    h("header", {}, h("h3", {}, name), button),
    rows.element,
    rest,
  );
  const update = () => {
    const coloured = colouring();
    const colours = new Map((coloured?.groups ?? []).map((one) => [one.id, one.colour]));
    setAttribute(button, "aria-pressed", String(coloured !== null));
    rows.update(shownBy(chosenOf(context)), ({ id }) => {
      const colour = colours.get(id);
      return colour === undefined ? null : groupColour(colour);
    });
    setText(rest, coloured ? restInWords(coloured) : "");
    rest.hidden = !rest.textContent;
  };
  return { element, rows, update };
}

/** Cells that no colour, or not the only one, stands for. @param {import("../state/answers.js").Colour} colour */
function restInWords({ without = 0, in_several: several = 0 }) {
  const parts = [
    without ? `${counted(without, "cell")} in none: grey` : "",
    several ? `${counted(several, "cell")} in several: coloured by the smallest` : "",
  ];
  return parts.filter(Boolean).join("; ");
}

/** Tells of each group whether it is shown. @param {Chosen} chosen @returns {(group: { id: string }) => boolean} */
function shownBy({ enabled, isolated, ...lists }) {
  const [hidden, shown] = [new Set(lists.hidden), new Set(lists.shown)];
  return ({ id }) => !enabled || shown.has(id) || !(isolated || hidden.has(id));
}

/** Sets of nodes: drawn as points where they are chosen. @param {Context} context @param {readonly GroupRow[]} nodes @returns {Part} */
function nodePart({ store }, nodes) {
  const rows = new GroupRows(nodes, {
    label: "drawn as points",
    turn: ({ id }, on) => {
      const others = store.status.marks.nodes.filter((one) => one !== id);
      store.set({ marks: { nodes: on ? [...others, id] : others } });
    },
  });
  const element = h(
    "section",
    { class: "group-part" },
    h("header", {}, h("h3", {}, "Sets of nodes, as points")),
    rows.element,
  );
  const update = () => {
    const places = new Map(store.status.marks.nodes.map((id, place) => [id, place]));
    rows.update(
      ({ id }) => places.has(id),
      ({ id }) => (places.has(id) ? markColour(/** @type {number} */ (places.get(id)) % MARKS) : null),
    );
  };
  return { element, rows, update };
}

/** Colours of sets of nodes, before they begin again. */
const MARKS = 6;
