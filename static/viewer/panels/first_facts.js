import { count, decimal } from "../state/numbers.js";
import { unitOf, withUnit } from "../state/units.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";

/**
 * What an engineer reads first: how large the mesh is, in how many parts, and how many of its cells are inverted.
 *
 * @param {import("../widgets/bind.js").Context} context
 */
export function firstFacts(context) {
  const element = h("dl", { class: "facts first-facts" });
  watch(context, { status: ["unit"], facts: ["summary", "description"] }, () => {
    const summary = context.facts.get("summary");
    const description = context.facts.get("description");
    element.hidden = !summary;
    if (!summary) return;
    const inverted = description?.findings && invertedIn(description.findings);
    const rows = [
      ["Extent", withUnit(extentInWords(summary.extent), unitOf(context.store.status, 1))],
      ["Parts", count(description?.components)],
      ["Inverted cells", inverted === 0 ? "none" : count(inverted)],
    ];
    element.replaceChildren(
      ...rows.flatMap(([name, value]) => [
        h("dt", {}, name),
        h("dd", name === "Inverted cells" && inverted ? { class: "outside" } : {}, value),
      ]),
    );
  });
  return element;
}

/** @param {readonly import("../state/answers.js").Finding[]} findings */
function invertedIn(findings) {
  return findings.find(({ id }) => id === "inverted_cells")?.count ?? 0;
}

/** Sides of the box, in the file's unit. @param {readonly (readonly number[])[]} extent */
function extentInWords([low, high]) {
  return high.map((end, axis) => decimal(end - low[axis])).join(" × ");
}
