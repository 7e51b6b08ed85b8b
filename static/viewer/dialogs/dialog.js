import { BY_HAND, copyText } from "../input/copying.js";
import { h } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";

/**
 * A dialog with a heading and a way out. It closes by Escape, by its button, and by a click beside it.
 *
 * @param {string} id @param {string} title @param {readonly Node[]} body @param {() => void} [opened] called each time it opens
 * @returns {HTMLDialogElement}
 */
export function dialog(id, title, body, opened) {
  const heading = h("h2", { id: `${id}-title` }, title);
  const close = h(
    "button",
    {
      type: "button",
      class: "button button-icon plain",
      "aria-label": "Close",
      onclick: () => element.close(),
    },
    icon("clear"),
  );
  const element = h(
    "dialog",
    { id, class: "dialog", "aria-labelledby": heading.id },
    h("header", {}, heading, close),
    h("div", { class: "dialog-body" }, ...body),
  );
  element.addEventListener("click", (event) => {
    if (event.target === element) element.close();
  });
  if (opened) {
    const show = element.showModal.bind(element);
    element.showModal = () => {
      opened();
      show();
    };
  }
  return element;
}

/** Text to be copied, with its button. @param {string} label @param {boolean} [long] whether it runs over lines */
export function copyField(label, long = false) {
  const field = long
    ? h("textarea", {
        class: "text copy-text",
        readonly: true,
        rows: 3,
        "aria-label": label,
        spellcheck: "false",
      })
    : h("input", {
        type: "text",
        class: "text copy-text",
        readonly: true,
        "aria-label": label,
        onfocus: (/** @type {FocusEvent} */ event) => /** @type {HTMLInputElement} */ (event.target).select(),
      });
  const button = h("button", { type: "button", class: "button", onclick: copy }, icon("copy"), "Copy");
  const element = h("div", { class: "copy-field" }, h("span", { class: "copy-label" }, label), field, button);

  async function copy() {
    const copied = await copyText(field.value, () => field.select());
    if (!copied) field.focus(); // its text is selected
    button.lastChild?.replaceWith(copied ? "Copied" : BY_HAND);
    setTimeout(() => button.lastChild?.replaceWith("Copy"), copied ? 1500 : 6000);
  }

  return {
    element,
    /** @param {string} value */
    show(value) {
      field.value = value;
      button.lastChild?.replaceWith("Copy");
    },
  };
}
