import { markColour } from "../colours/marks.js";
import { groupName, groupsOf } from "../state/groups.js";
import { count, counted } from "../state/numbers.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { swatch } from "../widgets/swatch.js";

/** @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../state/answers.js").Interface} Interface */

/** Pairs of groups that are listed: the largest of more. */
const MOST = 200;

/**
 * Where the groups of the chosen origin meet: faces that both share, and faces that lie on each other without being joined.
 *
 * @param {Context} context
 */
export function interfaceTable(context) {
  const list = h("ul", { class: "parts", "aria-label": "Interfaces between groups" });
  const rest = h("p", { class: "quiet" });
  const element = h("div", { class: "group-part" }, list, rest);
  /** @type {readonly Interface[] | null} */
  let listed = null;
  watch(context, { facts: ["interfaces", "description", "core"], status: ["marks.interfaces"] }, () => {
    const origin = context.store.status.marks.interfaces;
    const found = context.facts.get("interfaces");
    const rows = found && found.origin === origin ? found.rows : null;
    element.hidden = !origin;
    if (origin && !rows) void context.app.grouped.meet(origin);
    if (rows === listed) return;
    listed = rows;
    rest.textContent = rows ? restInWords(rows.length) : "";
    const known = new Map(groupsOf(context.facts).map((group) => [group.id, groupName(group)]));
    list.replaceChildren(...largest(rows ?? []).map((row) => line(known, row)));
  });
  return element;
}

/** @param {number} number of pairs */
function restInWords(number) {
  if (!number) return "No two of these groups meet.";
  return number > MOST ? `and ${counted(number - MOST, "smaller one")}` : "";
}

/** In their order where they are few; else those of most faces, not joined ones first. @param {readonly Interface[]} rows */
function largest(rows) {
  if (rows.length <= MOST) return rows;
  return [...rows].sort((a, b) => b.apart - a.apart || b.faces - a.faces).slice(0, MOST);
}

/** @param {ReadonlyMap<string, string>} known names by id @param {Interface} row */
function line(known, { groups, faces, apart, colour }) {
  const names = groups.map((id) => (id === null ? "no group" : (known.get(id) ?? id)));
  const words = [faces ? counted(faces, "face") : "", apart ? `${count(apart)} not joined` : ""].filter(
    Boolean,
  );
  return h(
    "li",
    {},
    h(
      "span",
      { class: "part-name", title: names.join(" and ") },
      colour !== null && swatch(markColour(colour)),
      h("span", { class: "group-name" }, names.join(" | ")),
    ),
    h("span", { class: `category-count${apart ? " outside" : ""}` }, words.join(", ")),
  );
}
