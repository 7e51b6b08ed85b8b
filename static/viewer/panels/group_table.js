import { groupName, groupsOf } from "../state/groups.js";
import { count, decimal } from "../state/numbers.js";
import { titled, unitOf } from "../state/units.js";
import { watch } from "../widgets/bind.js";
import { h, setText } from "../widgets/dom.js";

/**
 * @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../state/answers.js").GroupRow} GroupRow
 * @typedef {import("../state/answers.js").GroupMeasures} GroupMeasures
 */

const HEADS = ["Group", "Cells", "Invalid", "SJ min", "SJ mean", "Volume"];

/** What stands where a number is still to come. */
const COMING = ["…", "…", "…", "…"];

/** Size and quality of each group of cells, measured when the table is unfolded. @param {Context} context */
export function groupTable(context) {
  const heads = HEADS.map((name) => h("th", { scope: "col" }, name));
  const body = h("tbody");
  const table = h(
    "table",
    { class: "table group-table" },
    h("caption", { class: "visually-hidden" }, "Statistics of the groups of cells"),
    h("thead", {}, h("tr", {}, ...heads)),
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
  /** @type {unknown[]} */
  let told = [];
  const fill = () => {
    const { facts, store, app } = context;
    const all = groupsOf(facts);
    const measures = facts.get("groupMeasures");
    const known = all.filter(({ kind }) => kind === "cells");
    element.hidden = !known.length;
    setText(heads[5], titled(HEADS[5], unitOf(store.status, 3)));
    if (!element.open || !known.length) return;
    if (!measures) void app.grouped.measure();
    if (told[0] === all && told[1] === measures) return;
    told = [all, measures];
    body.replaceChildren(...known.map((group) => line(group, measures?.[group.id])));
  };
  element.addEventListener("toggle", fill);
  watch(context, { facts: ["description", "groupMeasures", "core"], status: ["unit"] }, fill);
  return element;
}

/** @param {GroupRow} group @param {GroupMeasures | undefined} found */
function line(group, found) {
  const name = groupName(group);
  const values = found
    ? [
        count(found.invalid),
        decimal(found.scaled_jacobian_min),
        decimal(found.scaled_jacobian_mean),
        decimal(found.volume),
      ]
    : COMING;
  return h(
    "tr",
    {},
    h("th", { scope: "row", title: name }, name),
    h("td", {}, count(group.count)),
    ...values.map((value, k) => h("td", k === 0 && found?.invalid ? { class: "outside" } : {}, value)),
  );
}
