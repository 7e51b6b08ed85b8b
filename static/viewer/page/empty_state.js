import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";

/** What stands where the mesh will be. @param {import("../widgets/bind.js").Context} context */
export function emptyState(context) {
  const formats = [...new Set(context.tables.formats.flatMap(({ extensions }) => extensions))].join(" ");
  const open = h(
    "button",
    {
      type: "button",
      class: "button button-strong",
      onclick: () => document.getElementById("file")?.click(),
    },
    "Open a mesh",
  );
  const { root } = context.app.host;
  const catalogue = root
    ? [" or ", h("a", { href: root, class: "link" }, "choose one from the catalogue")]
    : [];
  const again = h(
    "button",
    {
      type: "button",
      class: "button",
      onclick: () => context.facts.get("again")?.press(),
    },
    "Open again",
  );
  const last = h("p", { hidden: true }, again);
  const element = h(
    "div",
    { class: "empty" },
    h("p", { class: "empty-title" }, "Drop a hexahedral mesh anywhere"),
    h("p", {}, open, ...catalogue),
    last,
    h("p", { class: "empty-formats" }, formats),
  );
  watch(
    context,
    { facts: ["summary", "portrait"] },
    () => void (element.hidden = Boolean(context.facts.get("summary") ?? context.facts.get("portrait"))),
  );
  watch(context, { facts: ["again"] }, () => {
    const files = context.facts.get("again");
    last.hidden = !files;
    again.textContent = files ? `Open ${files.name} again` : "Open again";
  });
  return element;
}
