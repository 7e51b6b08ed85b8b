import { optionsOf } from "../state/choices.js";
import { KIND_NAMES } from "../state/kinds.js";
import { counted } from "../state/numbers.js";
import { h } from "../widgets/dom.js";
import { watch } from "../widgets/bind.js";
import { findings } from "./findings.js";
import { firstFacts } from "./first_facts.js";
import { goTo } from "./go_to.js";
import { keeping } from "./keeping.js";
import { offersChooser } from "./offers.js";
import { partList } from "./parts.js";
import { catalogueChooser } from "./catalogue.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/** @type {import("../widgets/section.js").Section} */
export const mesh = {
  id: "mesh",
  title: "Mesh",
  open: true,
  openNarrow: false,
  digestOf: { facts: ["summary"] },
  digest: ({ facts }) => {
    const summary = facts.get("summary");
    return summary ? counted(summary.cells, "cell") : "";
  },
  controls: [
    { kind: "custom", render: catalogueChooser },
    { kind: "custom", render: offersChooser },
    { kind: "custom", render: keeping },
    { kind: "custom", render: headline },
    { kind: "custom", render: goTo },
    { kind: "custom", render: firstFacts },
    {
      kind: "choice",
      id: "length-unit",
      label: "Unit",
      hint: "Of length, that the file's coordinates are in: told beside numbers, which stay the file's own",
      path: "unit",
      facts: ["summary"],
      options: optionsOf("unit"),
      hidden: ({ facts }) => !facts.get("summary"),
    },
    { kind: "custom", render: partList },
    { kind: "custom", render: findings },
  ],
};

/** "1,234 hexahedra, 5 wedges". @param {Record<string, number>} [kinds] */
export function kindsInWords(kinds = {}) {
  return Object.entries(kinds)
    .map(([kind, number]) => counted(number, ...(KIND_NAMES[kind] ?? [kind, kind])))
    .join(", ");
}

/** Kinds and vertices in one line. @param {Context} context */
function headline(context) {
  const element = h("p", { class: "headline" });
  watch(context, { facts: ["summary"] }, () => {
    const summary = context.facts.get("summary");
    element.hidden = !summary;
    if (summary)
      element.textContent = `${kindsInWords(summary.kinds) || counted(summary.cells, "cell")}; ${counted(summary.vertices, "vertex", "vertices")}`;
  });
  return element;
}
