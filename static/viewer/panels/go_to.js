import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/** "1043", "node 12", "n12", "element 7". */
const ASKED = /^\s*(?:(c|cell|e|el|element|n|node|v|vertex)\.?\s*)?#?(\d{1,15})\s*$/i;

/**
 * What was typed: a number, of a cell where nothing else is said.
 *
 * @param {string} text @param {"cell" | "vertex"} otherwise
 * @returns {{ kind: "cell" | "vertex", number: number } | null}
 */
export function parseGoal(text, otherwise) {
  const match = ASKED.exec(text);
  if (!match) return null;
  const word = match[1]?.toLowerCase()[0];
  const kind = !word ? otherwise : "nv".includes(word) ? "vertex" : "cell";
  return { kind, number: Number(match[2]) };
}

/** @param {KeyboardEvent} event */
const isUndo = ({ key, ctrlKey, metaKey, shiftKey, altKey }) =>
  (ctrlKey || metaKey) && !shiftKey && !altKey && key.toLowerCase() === "z";

/** Go to an element or a node by the number that the file gives it (SPEC R11). @param {Context} context */
export function goTo(context) {
  const kind = h(
    "select",
    { class: "choice", "aria-label": "What the number is of" },
    h("option", { value: "cell" }, "element"),
    h("option", { value: "vertex" }, "node"),
  );
  /** What was typed for where one has gone to last. */
  let gone = "";
  const go = async (/** @type {{ kind: "cell" | "vertex", number: number }} */ goal) => {
    const asked = input.value;
    input.select();
    gone = (await context.app.goTo(goal.kind, goal.number)) ? asked : "";
  };
  const input = h("input", {
    type: "text",
    class: "text",
    id: "go-to",
    inputmode: "numeric",
    autocomplete: "off",
    spellcheck: "false",
    oninput: () => input.setCustomValidity(""),
    onkeydown: (/** @type {KeyboardEvent} */ event) => {
      // The field keeps the focus for the next number; right after one, undo means the way there.
      if (!isUndo(event) || !gone || input.value !== gone) return;
      event.preventDefault();
      event.stopPropagation();
      gone = "";
      context.store.undo();
    },
  });
  const form = h(
    "form",
    {
      class: "row row-wide go-to",
      onsubmit: (/** @type {SubmitEvent} */ event) => {
        event.preventDefault();
        const goal = parseGoal(input.value, kind.value === "vertex" ? "vertex" : "cell");
        if (goal) return void go(goal);
        const found = input.value.trim();
        input.setCustomValidity(
          `${found ? `“${found}” is no number` : "No number"}: expected one such as 1043, or node 12`,
        );
        input.reportValidity();
      },
    },
    h("label", { class: "row-label", for: "go-to", title: "By the number of the file (N)" }, "Go to"),
    h("span", { class: "goal" }, kind, input, h("button", { type: "submit", class: "button" }, "Go")),
  );
  watch(context, { facts: ["summary"] }, () => (form.hidden = !context.facts.get("summary")));
  return form;
}
