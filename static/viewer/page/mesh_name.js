import { watch } from "../widgets/bind.js";
import { setText } from "../widgets/dom.js";
import { NAMING, namedIn } from "./named.js";

/** The open mesh's name in a line of its own, where the bar has no room for it. @param {import("../widgets/bind.js").Context} context */
export function meshName(context) {
  const element = /** @type {HTMLElement} */ (document.getElementById("mesh-name"));
  watch(context, { facts: NAMING }, () => {
    setText(element, namedIn(context.facts).name);
    element.hidden = !element.textContent;
  });
}
