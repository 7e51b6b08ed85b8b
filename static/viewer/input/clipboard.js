import { isTyping } from "./typing.js";

/**
 * Ctrl+C copies the settings where no text is selected, Ctrl+V applies settings (or opens a mesh file) from the
 * clipboard; text fields and dialogs keep both for themselves.
 *
 * @param {import("../app/app.js").App} app
 */
export function listenToClipboard(app) {
  const mine = (/** @type {Event} */ event) =>
    !isTyping(event.target) && !isTyping(document.activeElement) && !document.querySelector("dialog[open]");

  document.addEventListener("copy", (event) => {
    if (!mine(event) || String(getSelection()) !== "" || !event.clipboardData) return;
    event.clipboardData.setData("text/plain", app.documents.text());
    event.preventDefault();
    app.messages.say("note", "The settings were copied", { topic: "clipboard" });
  });

  document.addEventListener("paste", (event) => {
    if (!mine(event) || !event.clipboardData) return;
    const files = [...event.clipboardData.files];
    const text = event.clipboardData.getData("text/plain");
    if (!files.length && !text.trim()) return;
    event.preventDefault();
    if (files.length) app.openFiles(files).catch(() => {});
    else app.documents.applyText(text, "the clipboard");
  });
}
