import { h } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";
import { watch } from "../widgets/bind.js";

/** Over the picture: sees what is shown whole. @param {import("../widgets/bind.js").Context} context */
export function fitButton(context) {
  const button = h(
    "button",
    {
      type: "button",
      class: "button button-icon fit-button",
      title: "Fit what is shown (. or Home)",
      "aria-label": "Fit what is shown",
      onclick: () => context.app.views.fitShown(),
    },
    icon("fit"),
  );
  watch(context, { facts: ["shown"] }, () => void (button.hidden = !context.facts.get("shown")?.cells));
  return button;
}
