import { shareOf } from "../state/numbers.js";
import { readValue, reset, writeValue } from "./bind.js";
import { freshId, h, setAttribute } from "./dom.js";
import { numberField } from "./number_field.js";
import { row } from "./row.js";

/** @type {import("./bind.js").Range} */
const UNIT = [0, 1, 0.01];

/** @typedef {import("./bind.js").Context} Context @typedef {import("./bind.js").SliderControl} SliderControl */

/**
 * A slider that acts while it is dragged, with its number box; or, where `names` says what the steps are called, the
 * name of the step. `box` gives the number box another unit than the slider: `{read, write, range}`.
 *
 * @param {Context} context @param {SliderControl} control
 */
export function slider(context, control) {
  const id = control.id ?? freshId("slider");
  const range = () =>
    typeof control.range === "function" ? control.range(context) : (control.range ?? UNIT);
  const input = h("input", {
    type: "range",
    id,
    class: "slider",
    oninput: () => writeValue(control, Number(input.value), context, id),
    onchange: () => context.store.seal(),
    ondblclick: () => reset(control, context),
    onkeydown: (/** @type {KeyboardEvent} */ event) => {
      if (event.key === "Backspace" || event.key === "Delete") reset(control, context);
    },
    onpointerdown: () => control.press?.(context),
    onpointerup: () => control.release?.(context),
    onpointercancel: () => control.release?.(context),
  });
  const end = control.names ? stepName() : valueBox(context, control, range);

  function update() {
    const [low, high, step] = range();
    const value = readValue(control, context);
    setAttribute(input, "min", low);
    setAttribute(input, "max", high);
    setAttribute(input, "step", step);
    input.value = String(value);
    input.style.setProperty("--fill", high > low ? String(shareOf(value, low, high)) : "0");
    end.update(value);
  }

  function stepName() {
    const element = h("output", { class: "step-name", for: id });
    return {
      element,
      /** @param {number} value */
      update(value) {
        element.textContent = control.names?.[value] ?? "";
        setAttribute(input, "aria-valuetext", element.textContent);
      },
    };
  }

  return row(context, control, {
    body: [input, end.element],
    target: input,
    update,
    className: "row-slider",
  });
}

/** @param {Context} context @param {SliderControl} control @param {() => readonly [number, number, number]} range */
function valueBox(context, control, range) {
  const box = control.box ?? {};
  const field = numberField({
    label: `${control.label}, value`,
    digits: control.digits ?? 3,
    range: () => box.range?.(context) ?? range(),
    write(value) {
      if (value === null) return;
      if (box.write) context.store.set(box.write(value, context) ?? {});
      else writeValue(control, value, context);
    },
  });
  return {
    element: field.element,
    /** @param {number} value */
    update: (value) => field.show(box.read ? box.read(context) : value),
  };
}
