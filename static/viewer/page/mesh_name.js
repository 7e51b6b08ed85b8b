import { watch } from "../widgets/bind.js";
import { h, setText } from "../widgets/dom.js";

/** The open mesh's name over the picture, where the bar has no room for it. @param {import("../widgets/bind.js").Context} context */
export function meshName(context) {
  const element = h("p", { class: "mesh-name", "aria-hidden": "true" });
  watch(context, { facts: ["summary", "entry"] }, () => {
    const { facts } = context;
    setText(element, facts.get("entry")?.mesh.name ?? facts.get("summary")?.name ?? "");
    element.hidden = !element.textContent;
  });
  return element;
}
