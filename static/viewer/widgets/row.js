import { canReset, dependencies, reset, watch } from "./bind.js";
import { freshId, h, setAttribute, setText } from "./dom.js";

/** @typedef {import("./bind.js").Context} Context @typedef {import("./bind.js").Row} Row */

/**
 * The frame of a control: its switch, its label (double click resets), the widget itself, and why it has no effect.
 *
 * @param {Context} context @param {Row} control
 * @param {{ body: Node[], target: HTMLElement, update?: () => void, className?: string }} widget
 *   `target` is the element that the label names
 */
export function row(context, control, { body, target, update, className = "" }) {
  target.id ||= control.id ?? freshId("control");
  const why = h("span", { class: "row-why", id: `${target.id}-why` });
  const unit = control.unit ? h("span", { class: "row-unit", "aria-hidden": "true" }) : null;
  const label = h(
    "label",
    { class: "row-label", for: target.id, ondblclick: () => reset(control, context) },
    control.label,
    unit,
  );
  if (!control.label && control.hint) setAttribute(target, "aria-label", control.hint);
  const element = h(
    "div",
    { class: `row ${className}${control.full ? " row-full" : ""}`.trim() },
    toggle(context, control),
    label,
    ...body,
    why,
  );
  watch(context, dependencies(control), () => {
    const reason = control.why?.(context) ?? "";
    element.hidden = control.hidden?.(context) ?? false;
    element.classList.toggle("idle", reason !== "");
    setText(why, reason);
    if (unit) setText(unit, control.unit?.(context) ?? "");
    setAttribute(target, "aria-describedby", reason ? why.id : null);
    label.title = [control.hint, reason, canReset(control) && "Double-click: reset"]
      .filter(Boolean)
      .join("\n");
    update?.();
  });
  return element;
}

/** The on/off switch before a label. @param {Context} context @param {Row} control */
function toggle(context, control) {
  const path = control.enabled;
  if (!path) return null;
  const box = h("input", {
    type: "checkbox",
    class: "row-switch",
    "aria-label": `${control.label} on`,
    title: "On or off",
    onchange: () => context.store.setAt(path, box.checked),
  });
  watch(context, { status: [path] }, () => void (box.checked = context.store.valueAt(path) === true));
  return box;
}
