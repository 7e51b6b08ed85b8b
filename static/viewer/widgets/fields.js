import { reset, writeValue } from "./bind.js";
import { freshId, h } from "./dom.js";
import { icon } from "./icons.js";
import { numberField } from "./number_field.js";
import { row } from "./row.js";

/** @typedef {import("./bind.js").Context} Context @typedef {import("./bind.js").Control} Control */

/** Colour pickers side by side: `items` are {path, name}. @param {Context} context @param {Control} control */
export function colours(context, control) {
  const { items = [] } = control;
  const swatches = items.map((/** @type {{ path: string, name: string }} */ { path, name }) => {
    const id = freshId("colour");
    const picker = h("input", {
      type: "color",
      id,
      class: "swatch",
      oninput: () => context.store.setAt(path, picker.value, { undo: id }),
      onchange: () => context.store.seal(),
    });
    const text = h("input", {
      type: "text",
      class: "hex",
      maxlength: "7",
      spellcheck: "false",
      autocomplete: "off",
      "aria-label": `${name} colour, as hexadecimal`,
      onchange: () => {
        const clean = /^#?([0-9a-f]{6})$/i.exec(text.value.trim());
        if (clean) context.store.setAt(path, `#${clean[1].toLowerCase()}`);
        text.value = context.store.valueAt(path);
      },
    });
    const show = () => {
      picker.value = context.store.valueAt(path);
      if (document.activeElement !== text) text.value = picker.value;
    };
    const caption = h(
      "label",
      { class: "swatch-name", for: id, ondblclick: () => reset({ kind: "", path }, context) },
      name,
    );
    return {
      element: h("span", { class: "swatch-group" }, picker, items.length > 1 ? caption : null, text),
      show,
      picker,
    };
  });
  if (items.length === 1) swatches[0].picker.id = control.id ?? swatches[0].picker.id;
  const target =
    swatches.length === 1
      ? swatches[0].picker
      : h("span", { class: "swatches", role: "group", "aria-label": control.label });
  if (swatches.length > 1) target.append(...swatches.map((/** @type {any} */ swatch) => swatch.element));
  const body = swatches.length === 1 ? [swatches[0].element] : [target];
  const shown = {
    ...control,
    status: items.map((/** @type {any} */ item) => item.path).concat(control.status ?? []),
  };
  const update = () => swatches.forEach((/** @type {any} */ swatch) => swatch.show());
  return row(context, shown, { body, target, update, className: "row-wide" });
}

/**
 * Number boxes side by side: `items` are {name, read(context), write(value, context), optional?, range?}.
 *
 * @param {Context} context @param {Control} control
 */
export function numbers(context, control) {
  const { items = [] } = control;
  const group = h("span", { class: "numbers", role: "group", "aria-label": control.label });
  const fields = items.map((/** @type {any} */ item) => {
    const field = numberField({
      label: `${control.label}, ${item.name}`,
      digits: control.digits ?? 3,
      range: () => item.range?.(context) ?? [-Infinity, Infinity, 0.1],
      optional: item.optional,
      write: (value) => void context.store.set(item.write(value, context) ?? {}),
    });
    group.append(field.element);
    const show = () => {
      if (item.placeholder) field.element.placeholder = item.placeholder(context);
      field.show(item.read(context));
    };
    return { show };
  });
  const update = () => fields.forEach((/** @type {any} */ field) => field.show());
  return row(context, control, { body: [group], target: group, update, className: "row-wide" });
}

/**
 * Buttons in a row: `items` are {name, icon?, hint?, press(context, event), pressed?(context), disabled?(context)}.
 *
 * @param {Context} context @param {Control} control
 */
export function actions(context, control) {
  const { items = [] } = control;
  const group = h("span", { class: "actions", role: "group", "aria-label": control.label });
  const buttons = items.map((/** @type {any} */ item) => {
    const button = h(
      "button",
      {
        type: "button",
        class: item.icon && !item.text ? "button button-icon" : "button",
        title: item.hint ?? item.name,
        "aria-label": item.name,
        onclick: (/** @type {MouseEvent} */ event) => item.press(context, event),
      },
      item.icon ? icon(item.icon) : null,
      item.text ?? (item.icon ? null : item.name),
    );
    group.append(button);
    return { button, item };
  });
  const update = () => {
    for (const { button, item } of buttons) {
      if (item.pressed) button.setAttribute("aria-pressed", String(item.pressed(context)));
      button.disabled = item.disabled?.(context) ?? false;
    }
  };
  return row(context, control, { body: [group], target: group, update, className: "row-wide" });
}

/** A line of text to type: `read` and `write` as in every control; `write` may return {problem}. @param {Context} context @param {Control} control */
export function text(context, control) {
  const input = h("input", {
    type: "text",
    class: "text",
    id: control.id ?? freshId("text"),
    autocomplete: "off",
    spellcheck: "false",
    placeholder: control.hint,
    onchange: () => {
      const problem = control.box?.check?.(input.value, context) ?? "";
      input.setCustomValidity(problem);
      if (problem) input.reportValidity();
      else writeValue(control, input.value, context);
    },
  });
  const update = () => {
    if (document.activeElement !== input) input.value = control.read?.(context) ?? "";
  };
  return row(context, control, { body: [input], target: input, update, className: "row-wide" });
}
