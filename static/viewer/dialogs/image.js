import { LARGEST_SIDE as LARGEST } from "../app/saving.js";
import { clamp } from "../state/numbers.js";
import { h } from "../widgets/dom.js";
import { numberField } from "../widgets/number_field.js";
import { dialog } from "./dialog.js";

/**
 * Save the picture at any size up to 8192 pixels (SPEC S5).
 *
 * @param {import("../widgets/bind.js").Context} context @param {HTMLCanvasElement} canvas
 */
export function imageDialog(context, canvas) {
  const size = { width: 1920, height: 1080 };
  const field = (/** @type {"width" | "height"} */ side, /** @type {string} */ label) => {
    const one = numberField({
      label,
      digits: 0,
      range: () => [1, LARGEST, 10],
      write: (value) => void (size[side] = value === null ? size[side] : Math.round(value)),
    });
    return { ...one, row: h("div", { class: "field" }, h("span", {}, label), one.element) };
  };
  const [width, height] = [field("width", "Width"), field("height", "Height")];
  const transparent = h("input", { type: "checkbox", id: "image-transparent" });
  const sizes = h("div", { class: "actions", role: "group", "aria-label": "Sizes" });
  for (const [name, factor] of /** @type {[string, number][]} */ ([
    ["As shown", 1],
    ["2×", 2],
    ["4×", 4],
  ])) {
    sizes.append(
      h(
        "button",
        { type: "button", class: "button", onclick: () => setSize(factor * devicePixelRatio) },
        name,
      ),
    );
  }
  const save = h("button", { type: "button", class: "button button-strong", onclick: () => {
    element.close();
    context.app.saving.savePicture({ ...size, transparent: transparent.checked });
  } }, "Save PNG"); // prettier-ignore

  const many = h("button", { type: "button", class: "button", onclick: () => {
    element.close();
    /** @type {HTMLDialogElement} */ (document.getElementById("batch")).showModal();
  } }, "Of many meshes…"); // prettier-ignore

  /** @param {number} factor */
  function setSize(factor) {
    const most = LARGEST / Math.max(canvas.clientWidth, canvas.clientHeight, 1);
    size.width = Math.round(clamp(canvas.clientWidth * Math.min(factor, most), 1, LARGEST));
    size.height = Math.round(clamp(canvas.clientHeight * Math.min(factor, most), 1, LARGEST));
    width.show(size.width);
    height.show(size.height);
  }

  const element = dialog(
    "image",
    "Save a picture",
    [
      h("div", { class: "fields" }, width.row, height.row, sizes),
      h("label", { class: "check", for: transparent.id }, transparent, "Transparent background"),
      h(
        "p",
        { class: "quiet" },
        "The picture carries the settings: dropped on this page, it brings the view back.",
      ),
      h("div", { class: "dialog-end" }, many, save),
    ],
    () => setSize(devicePixelRatio),
  );
  return element;
}
