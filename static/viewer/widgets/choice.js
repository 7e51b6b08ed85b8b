import { readValue, writeValue } from "./bind.js";
import { freshId, h } from "./dom.js";
import { row } from "./row.js";

/**
 * @typedef {import("./bind.js").Context} Context
 * @typedef {import("./bind.js").Option} Option
 */

/** Fill a combo box, options of one group together. @param {HTMLSelectElement} select @param {readonly Option[]} options */
export function fill(select, options) {
  const key = JSON.stringify(options);
  if (select.dataset.options === key) return;
  select.dataset.options = key;
  /** @type {Map<string, HTMLOptGroupElement>} */
  const groups = new Map();
  select.replaceChildren();
  for (const { value, name, group } of options) {
    const option = h("option", { value }, name);
    if (!group) select.append(option);
    else {
      const parent = groups.get(group) ?? h("optgroup", { label: group });
      if (!groups.has(group)) select.append(parent);
      groups.set(group, parent);
      parent.append(option);
    }
  }
}

/** A combo box. `options` is a list of {value, name} or a function that makes it. @param {Context} context @param {import("./bind.js").ChoiceControl} control */
export function choice(context, control) {
  const select = h("select", {
    id: control.id ?? freshId("choice"),
    class: "choice",
    onchange: () => writeValue(control, select.value, context),
  });
  const update = () => {
    fill(select, typeof control.options === "function" ? control.options(context) : control.options);
    select.value = readValue(control, context);
  };
  return row(context, control, { body: [select], target: select, update, className: "row-wide" });
}

/** A check box with its text. @param {Context} context @param {import("./bind.js").ToggleControl} control */
export function toggle(context, control) {
  const box = h("input", {
    type: "checkbox",
    id: control.id ?? freshId("toggle"),
    class: "row-check",
    onchange: () => writeValue(control, box.checked, context),
  });
  const update = () => void (box.checked = readValue(control, context));
  return row(context, control, { body: [box], target: box, update, className: "row-wide" });
}
