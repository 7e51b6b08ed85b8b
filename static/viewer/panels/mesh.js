import { count, counted, decimal } from "../state/numbers.js";
import { h } from "../widgets/dom.js";
import { watch } from "../widgets/bind.js";
import { findings } from "./findings.js";
import { catalogueChooser } from "./catalogue.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/** @type {import("../widgets/section.js").Section} */
export const mesh = {
  id: "mesh",
  title: "Mesh",
  open: true,
  digestOf: { facts: ["summary"] },
  digest: ({ facts }) => (facts.get("summary") ? counted(facts.get("summary").cells, "cell") : ""),
  controls: [
    { kind: "custom", render: catalogueChooser },
    { kind: "custom", render: headline },
    { kind: "custom", render: findings },
    {
      kind: "more",
      id: "mesh-more",
      label: "Structure and extent",
      items: [{ kind: "custom", render: facts }],
    },
  ],
};

/** @type {Record<string, [string, string]>} */
const KIND_NAMES = {
  hexahedron: ["hexahedron", "hexahedra"],
  wedge: ["wedge", "wedges"],
  pyramid: ["pyramid", "pyramids"],
  tetrahedron: ["tetrahedron", "tetrahedra"],
};

/** "1,234 hexahedra, 5 wedges". @param {Record<string, number>} kinds */
export function kindsInWords(kinds) {
  return Object.entries(kinds ?? {})
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
      element.textContent = `${kindsInWords(summary.kinds)}; ${counted(summary.vertices, "vertex", "vertices")}`;
  });
  return element;
}

/** Rows of the table of facts: name and value. @param {any} summary @param {any} description @returns {[string, string][]} */
function rowsOf(summary, description) {
  const size = [0, 1, 2]
    .map((axis) => decimal(summary.extent[1][axis] - summary.extent[0][axis]))
    .join(" × ");
  /** @type {[string, string][]} */
  const rows = [
    ["Format", summary.format],
    ["Boundary faces", count(summary.boundary_faces)],
    ["Extent", size],
  ];
  if (!description) return rows;
  return [
    ...rows,
    ["Faces", count(description.faces)],
    ["Edges", count(description.edges)],
    ["Irregular edges inside", count(irregular(description.interior_edge_valence, 4))],
    ["Irregular on boundary", count(irregular(description.boundary_edge_valence, 2))],
    ["Layers", count(description.cells_per_depth?.length)],
    ["Components", count(description.components)],
    ["Unreferenced vertices", count(description.unreferenced_vertices)],
    ["Cells repeating a vertex", count(description.cells_repeating_a_vertex)],
  ];
}

/** @param {Record<string, number>} valences @param {number} regular */
function irregular(valences, regular) {
  return Object.entries(valences ?? {}).reduce(
    (total, [valence, n]) => (Number(valence) === regular ? total : total + n),
    0,
  );
}

/** @param {Context} context */
function facts(context) {
  const element = h("dl", { class: "facts" });
  watch(context, { facts: ["summary", "description"] }, () => {
    const summary = context.facts.get("summary");
    const rows = summary ? rowsOf(summary, context.facts.get("description")) : [];
    element.replaceChildren(...rows.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
    const notes = summary?.notes ?? [];
    if (notes.length) element.append(h("dt", {}, "Notes"), h("dd", { class: "prose" }, notes.join(" ")));
  });
  return element;
}
