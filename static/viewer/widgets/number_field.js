import { clamp, parsed, typed } from "../state/numbers.js";
import { h } from "./dom.js";

/**
 * A box for one number: shows three decimals, takes what is typed on Enter or when left, steps with the arrow keys,
 * and puts back what stood there when the text is no number.
 *
 * @param {object} options
 * @param {string} options.label for screen readers
 * @param {number} [options.digits]
 * @param {() => readonly [number, number, number]} options.range lowest, highest, step; infinite ends are open
 * @param {(value: number | null) => void} options.write null when the box was emptied and `optional` is set
 * @param {boolean} [options.optional]
 * @returns {{ element: HTMLInputElement, show: (value: number | null) => void }}
 */
export function numberField({ label, digits = 3, range, write, optional = false }) {
  /** @type {number | null} */
  let given = null;
  const element = h("input", {
    type: "text",
    inputmode: "decimal",
    class: "number",
    autocomplete: "off",
    spellcheck: "false",
    "aria-label": label,
    onfocus: () => element.select(),
    onchange: take,
    onkeydown: step,
  });

  /** @param {number | null} value */
  function show(value) {
    given = value;
    if (document.activeElement !== element || element.value === "") element.value = typed(value, digits);
  }

  function take() {
    const value = parsed(element.value);
    if (value === null && !(optional && element.value.trim() === "")) {
      element.value = typed(given, digits);
      return;
    }
    const [low, high] = range();
    const taken = value === null ? null : clamp(value, low, high);
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
