import { markColour } from "../colours/marks.js";
import { groupName, groupsOf } from "../state/groups.js";
import { count, counted } from "../state/numbers.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { swatch } from "../widgets/swatch.js";

/** @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../state/answers.js").Interface} Interface */

/**
 * Where the groups of the chosen origin meet: faces that both share, and faces that lie on each other without being joined.
 *
 * @param {Context} context
 */
export function interfaceTable(context) {
  const list = h("ul", { class: "parts", "aria-label": "Interfaces between groups" });
  const none = h("p", { class: "quiet" }, "No two of these groups meet.");
  const element = h("div", {}, list, none);
  watch(context, { facts: ["interfaces", "description", "core"], status: ["marks.interfaces"] }, () => {
    const origin = context.store.status.marks.interfaces;
    const found = context.facts.get("interfaces");
    const rows = found && found.origin === origin ? found.rows : null;
    element.hidden = !origin;
    if (origin && !rows) void context.app.grouped.meet(origin);
    none.hidden = !rows || rows.length > 0;
    list.replaceChildren(...(rows ?? []).map((row) => line(context, row)));
  });
  return element;
}

/** @param {Context} context @param {Interface} row */
function line({ facts }, { groups, faces, apart, colour }) {
  const known = new Map(groupsOf(facts).map((group) => [group.id, groupName(group)]));
  const names = groups.map((id) => (id === null ? "none" : (known.get(id) ?? id)));
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
