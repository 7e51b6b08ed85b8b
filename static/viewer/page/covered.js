import { watch } from "../widgets/bind.js";

/**
 * The view's middle is beside the inspector while a cell is in it that was flown to; on a narrow screen, where the inspector is a
 * sheet below, it stays.
 *
 * @param {import("../widgets/bind.js").Context} context @param {HTMLElement} inspector @param {HTMLCanvasElement} canvas
 */
export function centreBeside(context, inspector, canvas) {
  watch(context, { facts: ["cell", "flown"] }, () => {
    const shown = context.facts.get("cell") && context.facts.get("flown");
    const [cover, picture] = [inspector, canvas].map((element) => element.getBoundingClientRect());
    context.app.scene.covered =
      shown && cover.left > picture.left + 1 ? Math.max(0, picture.right - cover.left) : 0;
  });
}
