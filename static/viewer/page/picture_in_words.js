import { kindsInWords } from "../panels/mesh.js";
import { quantityOf } from "../state/quantity.js";
import { decimal } from "../state/numbers.js";
import { measured } from "../state/units.js";
import { watch } from "../widgets/bind.js";
import { setText } from "../widgets/dom.js";
import { shownInWords } from "./status_line.js";

/**
 * The picture's text equivalent (SPEC V8), as the canvas' description.
 *
 * @param {import("../widgets/bind.js").MeshContext} context @param {HTMLCanvasElement} canvas @param {HTMLElement} caption
 */
export function pictureInWords(context, canvas, caption) {
  watch(
    context,
    { status: ["filters", "colour", "separation.mode", "unit"], facts: ["summary", "shown", "statistics"] },
    () => {
      const words = sentences(context);
      setText(caption, words.join(" "));
      canvas.setAttribute("aria-label", words[0] ?? "No mesh is open");
    },
  );
}

/** @param {import("../widgets/bind.js").MeshContext} context @returns {string[]} */
function sentences(context) {
  const { facts, store } = context;
  const summary = facts.get("summary");
  if (!summary) return [];
  const { filters, colour } = store.status;
  const quantity = quantityOf(context);
  const statistics = facts.get("statistics")[quantity.id];
  const cuts = filters.planes.enabled
    ? filters.planes.items.filter((plane) => plane.enabled && plane.offset > 0)
    : [];
  return [
    `${summary.name}: ${kindsInWords(summary.kinds)}.`,
    `${shownInWords(context)}.`,
    ...cuts.map(
      ({ normal, offset }) =>
        `Cut at ${decimal(offset)} along ${normal.map((x) => decimal(x, 2)).join(", ")}.`,
    ),
    filters.peel.enabled && filters.peel.depth ? `Peeled by ${filters.peel.depth}.` : "",
    colour.by === "sides"
      ? "Boundary faces and exposed faces differ in colour."
      : `Coloured by ${colour.by === "kind" ? "cell kind" : quantity.name}.`,
    statistics
      ? `${quantity.name}: from ${decimal(statistics.min)} to ${measured(statistics.max, quantity.unit)}, mean ${measured(statistics.mean, quantity.unit)}.`
      : "",
  ].filter(Boolean);
}
