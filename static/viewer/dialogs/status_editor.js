import { parse, rejectionsInWords } from "../app/documents.js";
import { h } from "../widgets/dom.js";
import { dialog } from "./dialog.js";

/** The settings as text that can be edited (SPEC S2). @param {import("../widgets/bind.js").Context} context */
export function statusDialog({ app }) {
  const text = h("textarea", {
    class: "text status-text",
    rows: 24,
    spellcheck: "false",
    autocomplete: "off",
    "aria-label": "Settings as JSON",
  });
  const wrong = h("p", { class: "problem", role: "alert" });
  const apply = h("button", { type: "button", class: "button button-strong", onclick: run }, "Apply");
  const again = h("button", { type: "button", class: "button", onclick: fill }, "Take the present ones");

  function fill() {
    text.value = app.documents.text();
    wrong.textContent = "";
  }

  async function run() {
    try {
      const rejections = await app.documents.apply(parse(text.value, "the text"));
      wrong.textContent = rejections.length ? rejectionsInWords(rejections) : "";
      if (!rejections.length) element.close();
    } catch (error) {
      wrong.textContent = error instanceof Error ? error.message : String(error);
    }
  }

  const element = dialog(
    "status-editor",
    "Settings",
    [text, wrong, h("div", { class: "dialog-end" }, again, apply)],
    fill,
  );
  return element;
}
