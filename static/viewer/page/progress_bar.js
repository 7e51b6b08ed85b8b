import { watch } from "../widgets/bind.js";
import { h, setAttribute, setText } from "../widgets/dom.js";

/** The thin bar that says what is under way. @param {import("../widgets/bind.js").MeshContext} context */
export function progressBar(context) {
  const fill = h("span", { class: "progress-fill" });
  const bar = h(
    "span",
    {
      class: "progress-bar",
      role: "progressbar",
      "aria-label": "Progress",
      "aria-valuemin": 0,
      "aria-valuemax": 100,
    },
    fill,
  );
  const text = h("span", { class: "progress-text", role: "status" });
  const element = h("div", { class: "progress" }, bar, text);
  watch(context, { facts: ["progress"] }, () => {
    const task = context.facts.get("progress");
    element.classList.toggle("progress-on", Boolean(task));
    bar.hidden = !task;
    setText(text, task?.text ?? "");
    const fraction = task?.fraction ?? null;
    bar.classList.toggle("progress-unknown", fraction === null);
    fill.style.setProperty("--share", String(fraction ?? 1));
    setAttribute(bar, "aria-valuenow", fraction === null ? null : Math.round(fraction * 100));
  });
  return element;
}
