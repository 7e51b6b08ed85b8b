import { lookAt } from "../state/structure.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { PairMatrix } from "../widgets/pair_matrix.js";

/**
 * Which sheets cross and which run side by side; two that are clicked are shown in two colours (Xu and Chen 2018).
 *
 * @param {import("../widgets/bind.js").Context} context
 */
export function structureMatrix(context) {
  const { app, facts, store } = context;
  const matrix = new PairMatrix({
    label: "Sheets that meet",
    kind: ["sheet", "sheets"],
    choose: (a, b) => {
      store.seal();
      store.set(lookAt(store.status, "sheets", a === b ? [a] : [a, b]));
    },
  });
  const element = h(
    "details",
    { class: "more", id: "sheet-matrix", ontoggle: () => void fill() },
    h("summary", { class: "more-head" }, "Sheets that meet"),
    matrix.element,
  );
  /** The structure that the matrix shows. @type {unknown} */
  let shown = null;
  const fill = async () => {
    const structure = facts.get("structure");
    if (!element.open || !structure || shown === structure) return;
    shown = structure;
    const pairs = await app.structured.pairs();
    if (!pairs || facts.get("structure") !== structure) return;
    matrix.show(pairs);
    mark();
  };
  const mark = () =>
    matrix.mark(store.status.structure.kind === "sheets" ? store.status.structure.chosen : []);
  watch(context, { facts: ["structure"], status: ["structure"] }, () => {
    element.hidden = !facts.get("structure") || store.status.structure.kind !== "sheets";
    if (element.hidden) return;
    void fill();
    mark();
  });
  return element;
}
