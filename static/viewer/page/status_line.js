import { count, counted, decimal } from "../state/numbers.js";
import { cellInWords } from "../state/structure.js";
import { measured } from "../state/units.js";
import { followSecond } from "../state/second_facts.js";
import { watch } from "../widgets/bind.js";
import { h, setText } from "../widgets/dom.js";

/** Shown and all cells at the left, the cell under the pointer at the right. @param {import("../widgets/bind.js").Context} context */
export function statusLine(context) {
  const shown = h("span", { role: "status" });
  const hover = h("span", { class: "hover-cell" });
  const tell = () => {
    const second = context.facts.get("second");
    const parts = second
      ? [`A: ${shownInWords(context)}`, `B: ${shownInWords({ facts: second })}`]
      : [shownInWords(context)];
    setText(shown, parts.join(" · "));
  };
  /** The pointer is over one of both. */
  const tellHover = () => {
    const second = context.facts.get("second");
    const over = second?.get("hover") ? { ...context, facts: second } : context;
    setText(hover, hoverInWords(over));
  };
  watch(context, { facts: ["shown", "summary", "second"] }, tell);
  watch(context, { facts: ["hover", "tool", "changed"] }, tellHover);
  followSecond(context, ["shown", "summary"], tell);
  followSecond(context, ["hover"], tellHover);
  return [shown, hover];
}

/** @param {{ facts: import("../state/facts.js").Facts }} context */
export function shownInWords({ facts }) {
  const summary = facts.get("summary");
  const shown = facts.get("shown");
  if (!summary) return "";
  if (!shown) return counted(summary.cells, "cell");
  if (!shown.cells) return `no cell shown of ${count(summary.cells)}`;
  return `${count(shown.cells)} of ${counted(summary.cells, "cell")} shown, ${counted(shown.faces, "face")}`;
}

/** @type {Record<import("../state/facts.js").Tool, string>} */
const TOOL_WORDS = {
  turn: "",
  dig: "click a face to hide its cell",
  undig: "click a face to show the cell behind it",
  isolate: "click a cell to hide all others",
};

/** @param {Pick<import("../widgets/bind.js").Context, "facts" | "store">} context */
function hoverInWords({ facts, store }) {
  const hover = facts.get("hover");
  const tool = TOOL_WORDS[facts.get("tool")];
  if (!hover) return [facts.get("changed"), tool].filter(Boolean).join(" · ");
  const parts = hover.components ? ` (${hover.components.map((one) => decimal(one)).join(", ")})` : "";
  const value =
    typeof hover.value === "number"
      ? `, ${hover.name} ${measured(hover.value, hover.unit ?? "")}${parts}`
      : "";
  const structure = store.status.structure.kind === "none" ? "" : cellInWords(hover.structure);
  return [`cell ${facts.get("numbering").of(hover.cell)}${value}`, structure, tool]
    .filter(Boolean)
    .join(" · ");
}
