import { watch } from "../widgets/bind.js";

/**
 * @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../widgets/bind.js").Control} Control
 * @typedef {import("../widgets/section.js").Section} Section
 */

/** Milliseconds that a change is told for. */
const TOLD = 4000;

/**
 * Tells in the status line what keys, another window or a document has set while the section of its control is folded.
 *
 * @param {Context} context @param {readonly Section[]} sections
 */
export function tellChanges(context, sections) {
  const { store, facts } = context;
  const controls = sections.flatMap((section) =>
    section.controls.flatMap(withPath).map((control) => ({ control, section: section.id })),
  );
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let ending;
  store.on("*", (_, changed) => {
    if (facts.get("posing")) return;
    const told = controls.filter(
      ({ control, section }) => changed.includes(control.path ?? "") && isFolded(section),
    );
    if (!told.length) return;
    clearTimeout(ending);
    ending = setTimeout(() => facts.set({ changed: "" }), TOLD);
    const words = told.map(({ control }) => `${control.label}: ${valueInWords(context, control)}`);
    facts.set({ changed: told.length > 2 ? `${told.length} settings changed` : words.join(", ") });
  });
  watch(context, { facts: ["summary"] }, () => facts.set({ changed: "" }));
}

/** A control and those that it folds away, as far as each is one setting. @param {Control} control @returns {Control[]} */
function withPath(control) {
  const inner = [...(control.more ?? []), ...(control.kind === "more" ? control.items : [])];
  return [...(control.path && control.label ? [control] : []), ...inner.flatMap(withPath)];
}

/** @param {string} section */
function isFolded(section) {
  const element = /** @type {HTMLDetailsElement | null} */ (document.getElementById(`section-${section}`));
  return element !== null && !element.open;
}

/** @param {Context} context @param {Control} control */
function valueInWords(context, control) {
  const value = context.store.valueAt(control.path ?? "");
  if (control.kind === "choice") {
    const options = typeof control.options === "function" ? control.options(context) : control.options;
    return options.find((option) => option.value === value)?.name ?? String(value);
  }
  if (control.kind === "slider" && control.names) return control.names[Number(value)];
  return typeof value === "boolean" ? (value ? "on" : "off") : String(value);
}
