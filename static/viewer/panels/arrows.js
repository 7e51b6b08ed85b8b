import { rangeOf } from "../state/choices.js";
import { inWords, vectorOptions } from "../state/arrows.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/** @param {Context} context */
const noneChosen = ({ store }) => store.status.arrows.attribute === "";

/** Vectors of the file as arrows: left out where the file has none. @type {readonly import("../widgets/bind.js").Control[]} */
export const arrows = [
  {
    kind: "choice",
    id: "arrows",
    label: "Arrows",
    hint: "Vectors of the file on the shown surface; those that point into it end there",
    path: "arrows.attribute",
    facts: ["summary"],
    options: ({ facts }) => [{ value: "", name: "none" }, ...vectorOptions(facts.get("summary"))],
    hidden: (context) => noneChosen(context) && !vectorOptions(context.facts.get("summary")).length,
  },
  {
    kind: "slider",
    id: "arrows-length",
    label: "Length",
    hint: "Of the longest vector of the mesh, in diagonals",
    path: "arrows.length",
    status: ["arrows.attribute"],
    range: [0.005, 0.2, 0.005],
    box: { range: rangeOf("arrows.length", 0.001) },
    hidden: noneChosen,
  },
  { kind: "custom", render: told },
  {
    kind: "colours",
    label: "Ink",
    status: ["arrows.attribute"],
    items: [{ path: "arrows.colour", name: "Of the arrows" }],
    hidden: noneChosen,
  },
];

/** How many there are, and what their length means. @param {Context} context */
function told(context) {
  const element = h("p", { class: "arrows-told" });
  watch(context, { status: ["arrows.attribute"], facts: ["arrows"] }, () => {
    const known = context.facts.get("arrows");
    element.hidden = noneChosen(context) || !known;
    element.textContent = known ? inWords(known) : "";
  });
  return element;
}
