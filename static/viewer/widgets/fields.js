import { readValue, reset, writeValue } from "./bind.js";
import { freshId, h } from "./dom.js";
import { icon } from "./icons.js";
import { numberField } from "./number_field.js";
import { row } from "./row.js";

/** @typedef {import("./bind.js").Context} Context */

/** Colour pickers side by side. @param {Context} context @param {import("./bind.js").ColoursControl} control */
export function colours(context, control) {
  const { items } = control;
  const colourAt = (/** @type {string} */ path) => String(context.store.valueAt(path));
  const swatches = items.map(({ path, name }) => {
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
        text.value = colourAt(path);
      },
    });
    const show = () => {
      picker.value = colourAt(path);
      if (document.activeElement !== text) text.value = picker.value;
    };
    const caption = h(
      "label",
      { class: "swatch-name", for: id, ondblclick: () => reset({ path }, context) },
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
  if (swatches.length > 1) target.append(...swatches.map((swatch) => swatch.element));
  const body = swatches.length === 1 ? [swatches[0].element] : [target];
  const status = [...items.map(({ path }) => path), ...(control.status ?? [])];
  const update = () => swatches.forEach((swatch) => swatch.show());
  return row(context, { ...control, status }, { body, target, update, className: "row-wide" });
}

/** Number boxes side by side. @param {Context} context @param {import("./bind.js").NumbersControl} control */
export function numbers(context, control) {
  const { items } = control;
  const group = h("span", { class: "numbers", role: "group", "aria-label": control.label });
  const fields = items.map((item) => {
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
  const update = () => fields.forEach((field) => field.show());
  return row(context, control, { body: [group], target: group, update, className: "row-wide" });
}

/** Buttons in a row. @param {Context} context @param {import("./bind.js").ActionsControl} control */
export function actions(context, control) {
  const { items } = control;
  const group = h("span", { class: "actions", role: "group", "aria-label": control.label });
  const buttons = items.map((item) => {
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

/** A line of text to type. @param {Context} context @param {import("./bind.js").TextControl} control */
export function text(context, control) {
  const input = h("input", {
    type: "text",
    class: "text",
    id: control.id ?? freshId("text"),
    autocomplete: "off",
    spellcheck: "false",
    placeholder: control.hint,
    onchange: () => {
      const wrong = control.check?.(input.value, context) ?? "";
      input.setCustomValidity(wrong);
      if (wrong) input.reportValidity();
      else writeValue(control, input.value, context);
    },
  });
  const update = () => {
    if (document.activeElement !== input) input.value = readValue(control, context);
  };
  return row(context, control, { body: [input], target: input, update, className: "row-wide" });
}
