import { h } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";
import { copyField, dialog } from "./dialog.js";

/** Link, embedding, and the settings as text and file (SPEC S2). @param {import("../widgets/bind.js").Context} context */
export function shareDialog({ app, facts }) {
  const link = copyField("Link");
  const frame = copyField("Embed", true);
  const badge = copyField("Badge");
  const local = h(
    "p",
    { class: "quiet", hidden: true },
    "The mesh is a file of yours: the link carries the view, and whoever opens it has to add the mesh.",
  );
  const settings = copyField("Settings", true);
  link.element.hidden = !app.host.shares;
  const edit = () => {
    element.close();
    /** @type {HTMLDialogElement} */ (document.getElementById("status-editor")).showModal();
  };
  const actions = h(
    "div",
    { class: "actions" },
    h(
      "button",
      { type: "button", class: "button", onclick: () => app.saving.saveStatus() },
      icon("save"),
      "Save as a file",
    ),
    h(
      "button",
      { type: "button", class: "button", onclick: () => document.getElementById("file")?.click() },
      icon("open"),
      "Load",
    ),
    h("button", { type: "button", class: "button", onclick: edit }, icon("edit"), "Edit"),
  );
  const element = dialog(
    "share",
    "Share",
    [link.element, frame.element, badge.element, local, settings.element, actions],
    async () => {
      const named = new URLSearchParams(location.search).has("mesh");
      local.hidden = !app.host.shares || !facts.get("summary") || named;
      for (const field of [frame, badge]) field.element.hidden = !app.host.shares || !named; // nobody could open it
      settings.show(app.documents.text());
      for (const field of [link, frame, badge]) field.show(""); // never that of another view
      if (!app.host.shares) return;
      const address = await app.saving.link();
      link.show(address);
      const name = facts.get("entry")?.mesh.name ?? facts.get("summary")?.name ?? "HexaLab";
      frame.show(embedCode(address, name));
      badge.show(`[![open in HexaLab](${new URL("../badge.svg", document.baseURI).href})](${address})`);
    },
  );
  return element;
}

/**
 * A frame that shows a mesh's picture, and loads the mesh where that is clicked (`embed/`).
 *
 * @param {string} address of the viewer @param {string} name
 */
function embedCode(address, name) {
  const frame = new URL(address);
  frame.searchParams.set("title", name);
  frame.pathname = frame.pathname.replace(/viewer\/(index\.html)?$/, "embed/");
  const title = `${name}, HexaLab`.replaceAll(/[&<>"]/g, (mark) => `&#${mark.charCodeAt(0)};`);
  return `<iframe src="${frame.href.replaceAll("&", "&amp;")}" width="720" height="480" loading="lazy" title="${title}"></iframe>`;
}
