import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

const WORDS = { kept: "Kept offline", free: "", coming: "Being kept offline" };
const BUTTONS = { kept: "Free", free: "Keep offline", coming: "Cancel" };
const HINTS = {
  kept: "Let this browser keep the mesh no more",
  free: "Have this browser keep the mesh until you free it, so that it opens without a network",
  coming: "What has come stays",
};

/**
 * "Keep offline" for a mesh that came from an address, and the way to all that is kept.
 *
 * @param {Context} context
 */
export function keeping(context) {
  const { facts, app } = context;
  const button = h("button", { type: "button", class: "link", onclick: () => app.keeping.toggle() });
  const all = h(
    "a",
    { href: new URL("offline/index.html", new URL(app.host.root, document.baseURI)).href, target: "_blank" },
    "All that is kept",
  );
  const words = h("span", { class: "quiet", role: "status" });
  const element = h("p", { class: "keeping" }, words, button, all);
  watch(context, { facts: ["offline"] }, () => {
    const state = facts.get("offline");
    element.hidden = !state;
    if (!state) return;
    words.textContent = WORDS[state];
    button.textContent = BUTTONS[state];
    button.title = HINTS[state];
    all.hidden = state !== "kept";
  });
  return element;
}
