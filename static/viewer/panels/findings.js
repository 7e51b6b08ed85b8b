import { h } from "../widgets/dom.js";
import { watch } from "../widgets/bind.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/** @type {Record<import("../state/answers.js").Finding["severity"], string>} */
const SEVERITY_MARKS = { error: "✕", warning: "!", note: "i" };

/**
 * What the diagnosis found (SPEC R9), a line for each, with a button that isolates the cells concerned; and what was
 * noted while the file was read, so that nothing is guessed or left out in silence.
 *
 * @param {Context} context
 */
export function findings(context) {
  const list = h("ul", { class: "findings", "aria-label": "Findings of the diagnosis" });
  watch(context, { facts: ["description"] }, () => {
    const found = context.facts.get("description")?.findings ?? [];
    list.hidden = !found.length;
    list.replaceChildren(...found.map((finding) => line(context, finding)));
  });
  return list;
}

/** @param {Context} context @param {import("../state/answers.js").Finding} finding */
function line(context, finding) {
  const mark = h(
    "span",
    { class: `mark mark-${finding.severity}`, "aria-label": finding.severity, role: "img" },
    SEVERITY_MARKS[finding.severity],
  );
  const show = h(
    "button",
    {
      type: "button",
      class: "link",
      "aria-label": `Show: ${finding.message}`,
      onclick: () => context.app.showFinding(finding),
    },
    "show",
  );
  return h(
    "li",
    {},
    mark,
    h("span", { class: "finding-text" }, finding.message),
    finding.has_cells ? show : null,
  );
}
