import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { NAMING, namedIn } from "./named.js";

/** In a frame of another page: what the mesh is, and a way to the whole viewer. @param {import("../widgets/bind.js").Context} context */
export function embeddedCorner(context) {
  const { app } = context;
  const mesh = h("span", { class: "embedded-name" });
  const link = h("a", { target: "_blank", rel: "noopener" }, "Open in HexaLab");
  const follow = () => void app.saving.link().then((address) => link.setAttribute("href", address));
  for (const event of ["pointerenter", "focus", "touchstart"]) link.addEventListener(event, follow);
  watch(context, { facts: NAMING }, () => {
    const { name, entry } = namedIn(context.facts);
    const from = entry ? `, ${entry.source.authors[0] ?? ""} ${entry.source.year ?? ""}`.trimEnd() : "";
    mesh.textContent = `${name}${from}`;
    follow();
  });
  return h("p", { class: "embedded" }, mesh, link);
}
