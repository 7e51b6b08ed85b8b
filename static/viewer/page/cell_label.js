import { quantityOf } from "../state/quantity.js";
import { measured } from "../state/units.js";
import { watch } from "../widgets/bind.js";
import { h, setText } from "../widgets/dom.js";

/**
 * A short label at the cell that is meant: its number, and the value that is looked at.
 *
 * @param {import("../widgets/bind.js").MeshContext} context
 * @param {import("../scene/scene_like.js").SceneLike} scene
 */
export function cellLabel(context, scene) {
  const element = h("p", { class: "cell-label", hidden: true, "aria-hidden": "true" });
  /** @type {import("../scene/scene_like.js").Place | null} */
  let place = null;
  const show = () => {
    const cell = context.facts.get("cell");
    element.hidden = !cell || !place;
    if (!cell || !place) return;
    const { id, symbol, name, unit } = quantityOf(context);
    const value = cell.metrics[id];
    const words = value === undefined ? "" : ` · ${symbol || name} ${measured(value, unit)}`;
    setText(element, `${cell.number}${words}`);
    element.style.translate = `${Math.round(place.x)}px ${Math.round(place.y)}px`;
  };
  scene.on("marked", (at) => {
    place = at;
    show();
  });
  watch(context, { facts: ["cell"], status: ["colour", "unit"] }, show);
  return element;
}
