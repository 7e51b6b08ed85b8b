import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";

/** In a frame of another page: what the mesh is, and a way to the whole viewer. @param {import("../widgets/bind.js").Context} context */
export function embeddedCorner(context) {
  const { app } = context;
  const name = h("span", { class: "embedded-name" });
  const link = h("a", { target: "_blank", rel: "noopener" }, "Open in HexaLab");
  const follow = () => void app.saving.link().then((address) => link.setAttribute("href", address));
  for (const event of ["pointerenter", "focus", "touchstart"]) link.addEventListener(event, follow);
  watch(context, { facts: ["entry", "summary"] }, () => {
    const entry = context.facts.get("entry");
    const from = entry ? `, ${entry.source.authors[0] ?? ""} ${entry.source.year ?? ""}`.trimEnd() : "";
    name.textContent = `${entry?.mesh.name ?? context.facts.get("summary")?.name ?? ""}${from}`;
    follow();
  });
  return h("p", { class: "embedded" }, name, link);
}
