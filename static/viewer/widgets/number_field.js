import { clamp, parsed, typed } from "../state/numbers.js";
import { freshId, h } from "./dom.js";

/**
 * A box for one number: shows three decimals, takes what is typed on Enter or when left, steps with the arrow keys.
 * Text that is no number stays, marked as such, until it is mended; Escape puts back what stood there.
 *
 * @param {object} options
 * @param {string} options.label for screen readers
 * @param {number} [options.digits] decimals that are shown; without any, whole numbers are taken
 * @param {() => readonly [number, number, number]} options.range lowest, highest, step; infinite ends are open
 * @param {(value: number | null) => void} options.write null when the box was emptied and `optional` is set
 * @param {boolean} [options.optional]
 * @returns {{ element: HTMLInputElement, show: (value: number | null) => void }}
 */
export function numberField({ label, digits = 3, range, write, optional = false }) {
  /** @type {number | null} */
  let given = null;
  const note = h("span", { class: "refusal", role: "alert" });
  const element = h("input", {
    type: "text",
    inputmode: "decimal",
    class: "number",
    autocomplete: "off",
    spellcheck: "false",
    "aria-label": label,
    onfocus: () => element.select(),
    onchange: take,
    oninput: () => mark(false),
    onkeydown: (/** @type {KeyboardEvent} */ event) =>
      event.key === "Escape" ? restore(event) : step(event),
  });

  /** @param {number | null} value */
  function show(value) {
    given = value;
    if (document.activeElement === element && element.value !== "") return;
    element.value = typed(value, digits);
    mark(false);
  }

  /** @param {boolean} refused */
  function mark(refused) {
    element.setAttribute("aria-invalid", String(refused));
    if (!refused) return note.remove();
    note.textContent = `‘${element.value.trim().slice(0, 12)}’ is no number: mend it, or press Escape`;
    element.after(note);
    note.id ||= freshId("refusal");
    element.setAttribute("aria-errormessage", note.id);
  }

  /** @param {KeyboardEvent} event */
  function restore(event) {
    const before = typed(given, digits);
    if (element.value === before) return;
    event.stopPropagation(); // else the dialog or the inspector around it closes
    event.preventDefault();
    element.value = before;
    element.select();
    mark(false);
  }

  function take() {
    const value = parsed(element.value);
    if (value === null && !(optional && element.value.trim() === "")) {
      mark(true);
      return;
    }
    const [low, high] = range();
    const taken = value === null ? null : clamp(digits ? value : Math.round(value), low, high);
    element.value = typed(taken, digits);
    write(taken);
  }

  /** @param {KeyboardEvent} event */
  function step(event) {
    const sign = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (event.key === "Enter") element.select();
    if (!sign) return;
    event.preventDefault();
    const [low, high, size] = range();
    const value = clamp((parsed(element.value) ?? 0) + sign * size * (event.shiftKey ? 10 : 1), low, high);
    element.value = typed(value, digits);
    write(value);
  }

  return { element, show };
}
