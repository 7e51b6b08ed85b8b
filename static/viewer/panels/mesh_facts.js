import { count } from "../state/numbers.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/** Rows of the table of facts: name and value. @param {import("../state/facts.js").MeshSummary} summary @param {Partial<import("../state/answers.js").Description> | null} description @returns {[string, string][]} */
function rowsOf(summary, description) {
  /** @type {[string, string][]} */
  const rows = [
    ["Format", summary.format ?? "–"],
    ["Boundary faces", count(summary.boundary_faces)],
  ];
  if (!description) return rows;
  return [
    ...rows,
    ["Faces", count(description.faces)],
    ["Edges", count(description.edges)],
    ["Irregular edges inside", irregular(description.interior_edge_valence, 4)],
    ["Irregular on boundary", irregular(description.boundary_edge_valence, 2)],
    ["Layers", count(description.cells_per_depth?.length)],
    ["Unreferenced vertices", count(description.unreferenced_vertices)],
    ["Cells repeating a vertex", count(description.cells_repeating_a_vertex)],
  ];
}

/** How many edges are not regular. @param {Record<string, number> | undefined} valences @param {number} regular */
function irregular(valences, regular) {
  if (!valences) return count(null);
  const others = Object.entries(valences).filter(([valence]) => Number(valence) !== regular);
  return count(others.reduce((total, [, number]) => total + number, 0));
}

/**
 * What is known of the mesh, as names and values.
 *
 * @param {Context} context
 */
export function meshFacts(context) {
  const element = h("dl", { class: "facts" });
  watch(context, { facts: ["summary", "description"] }, () => {
    const summary = context.facts.get("summary");
    const rows = summary ? rowsOf(summary, context.facts.get("description")) : [];
    element.replaceChildren(...rows.flatMap(([name, value]) => [h("dt", {}, name), h("dd", {}, value)]));
  });
  return element;
}
