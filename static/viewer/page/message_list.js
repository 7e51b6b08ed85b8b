import { BY_HAND, copyText } from "../input/copying.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { icon } from "../widgets/icons.js";

/**
 * Messages over the picture's lower edge: they stay until dismissed, and can be copied.
 *
 * @param {import("../widgets/bind.js").Context} context
 */
export function messageList(context) {
  const list = h("div", { class: "messages", role: "log", "aria-live": "polite", "aria-label": "Messages" });
  /** @type {Map<number, HTMLElement>} */
  const lines = new Map();
  watch(context, { facts: ["messages"] }, () => {
    const messages = context.facts.get("messages");
    const ids = new Set(messages.map((message) => message.id));
    for (const [id, element] of lines) {
      if (ids.has(id)) continue;
      element.remove();
      lines.delete(id);
    }
    for (const message of messages) {
      if (lines.has(message.id)) continue;
      const element = line(context, message);
      lines.set(message.id, element);
      list.append(element);
    }
  });
  return list;
}

/** @param {import("../widgets/bind.js").Context} context @param {import("../state/facts.js").Message} message */
function line({ app }, message) {
  const { id, severity, text, action } = message;
  const said = h("span", {}, text);
  const act =
    action &&
    h(
      "button",
      { type: "button", class: "link", onclick: () => (app.messages.dismiss(id), action.press()) },
      action.name,
    );
  const copy = h(
    "button",
    {
      type: "button",
      class: "button button-icon plain",
      title: "Copy",
      "aria-label": "Copy this message",
      onclick: async () => {
        const copied = await copyText(text, () => getSelection()?.selectAllChildren(said));
        copy.title = copied ? "Copied" : BY_HAND;
        copy.setAttribute("aria-label", copied ? "Copied" : `Not copied: ${BY_HAND}`);
        copy.classList.toggle("done", copied);
      },
    },
    icon("copy"),
  );
  const close = h(
    "button",
    {
      type: "button",
      class: "button button-icon plain",
      title: "Dismiss",
      "aria-label": "Dismiss this message",
      onclick: () => app.messages.dismiss(id),
    },
    icon("clear"),
  );
  const words = h(
    "span",
    { class: "message-text" },
    h("span", { class: "visually-hidden" }, `${severity}: `),
    said,
  );
  return h("div", { class: `message message-${severity}` }, words, act, copy, close);
}
