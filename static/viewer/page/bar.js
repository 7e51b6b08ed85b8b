import { referenceOf } from "../panels/catalogue.js";
import { h } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";
import { watch } from "../widgets/bind.js";
import { NAMING, namedIn } from "./named.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/**
 * The bar: what is open and where it is from, and what can be done with the whole.
 *
 * @param {Context} context @param {Record<string, HTMLDialogElement>} dialogs @returns {Node[]}
 */
export function bar(context, dialogs) {
  return [
    title(context),
    h("div", { class: "bar-actions" }, ...history(context), opener(context), ...openers(dialogs)),
  ];
}

/** @param {Context} context */
function title(context) {
  const mesh = h("span", { class: "bar-mesh" });
  const source = h("span", { class: "bar-source quiet" });
  const body = h("div", { class: "popover-body", id: "citation", popover: "auto" });
  const cite = h("button", { type: "button", class: "link", popovertarget: body.id, hidden: true }, "cite");
  const element = h(
    "h1",
    { class: "bar-title" },
    h("span", { class: "visually-hidden" }, "Viewer "),
    mesh,
    source,
  );
  watch(context, { facts: NAMING }, () => {
    const { name, entry } = namedIn(context.facts);
    mesh.textContent = name;
    source.textContent = entry
      ? `${entry.source.title}${entry.source.year ? ` (${entry.source.year})` : ""}`
      : "";
    cite.hidden = !entry;
    if (entry) body.replaceChildren(referenceOf(entry.source));
    document.title = name ? `${name} · HexaLab` : "HexaLab";
  });
  return h("div", { class: "bar-what" }, element, cite, body);
}

/** @param {Context} context */
function history(context) {
  const undo = h(
    "button",
    {
      type: "button",
      class: "button button-icon plain",
      title: "Undo (Ctrl+Z)",
      "aria-label": "Undo",
      onclick: () => context.store.undo(),
    },
    icon("undo"),
  );
  const redo = h(
    "button",
    {
      type: "button",
      class: "button button-icon plain",
      title: "Redo (Ctrl+Shift+Z)",
      "aria-label": "Redo",
      onclick: () => context.store.redo(),
    },
    icon("redo"),
  );
  watch(context, { status: ["*"] }, () => {
    undo.disabled = !context.store.canUndo;
    redo.disabled = !context.store.canRedo;
  });
  return [undo, redo, h("span", { class: "bar-rule", "aria-hidden": "true" })];
}

/** @param {Context} context */
function opener({ app }) {
  const input = h("input", {
    type: "file",
    id: "file",
    multiple: true,
    class: "visually-hidden",
    tabindex: -1,
    "aria-label": "Mesh, settings or picture",
    onchange: () => {
      const files = [...(input.files ?? [])];
      input.value = "";
      if (files.length) app.openFiles(files).catch(() => {});
    },
  });
  const button = barButton("open", "Open", "Open a mesh, settings or a picture (O)", () => input.click());
  return h("span", {}, button, input);
}

/** @param {Record<string, HTMLDialogElement>} dialogs */
function openers(dialogs) {
  return [
    barButton("share", "Share", "Link, embedding, settings", () => dialogs.share.showModal()),
    barButton("image", "Image", "Save a picture", () => dialogs.image.showModal()),
    barButton("save", "Save", "Save cells, surface, a page, a report or a turntable", () =>
      dialogs.save.showModal(),
    ),
    barButton("help", "", "Keys and help (?)", () => dialogs.help.showModal(), "Help"),
  ];
}

/** @param {string} name @param {string} text @param {string} hint @param {() => void} press @param {string} [label] */
function barButton(name, text, hint, press, label = text) {
  return h(
    "button",
    { type: "button", class: "button plain", title: hint, "aria-label": label, onclick: press },
    icon(name),
    text ? h("span", { class: "bar-text" }, text) : null,
  );
}
