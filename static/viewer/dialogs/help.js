import { KEYS, OTHER_KEYS } from "../input/keys.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";
import { dialog } from "./dialog.js";

/** @type {Record<string, string>} */
const KEY_NAMES = { PageUp: "Page up", PageDown: "Page down", Escape: "Esc" };

/** "Ctrl+Shift+z" as key caps. @param {string} key */
function caps(key) {
  return key.split("+").filter(Boolean).map((part) => h("kbd", {}, part.length === 1 ? part.toUpperCase() : (KEY_NAMES[part] ?? part))); // prettier-ignore
}

/** The cheat sheet. @param {import("../widgets/bind.js").Context} context */
export function helpDialog(context) {
  const { tables } = context;
  const rows = [...KEYS, ...OTHER_KEYS];
  const groups = [...new Set(rows.map(({ group }) => group))];
  const sheets = groups.map((group) =>
    h(
      "section",
      {},
      h("h3", {}, group),
      h(
        "dl",
        { class: "keys" },
        ...rows
          .filter((row) => row.group === group)
          .flatMap(({ keys, what }) => [
            h("dt", {}, ...(keys[0] === "+" ? [h("kbd", {}, "+")] : caps(keys[0]))),
            h("dd", {}, what),
          ]),
      ),
    ),
  );
  const mouse = h(
    "p",
    { class: "quiet" },
    "Drag turns, the wheel zooms to the pointer, the right button moves. A click inspects a cell. Numbers can be typed; a double click on a label resets its control. Files dropped anywhere open: meshes, settings, and pictures that HexaLab saved.",
  );
  return dialog("help", "Keys", [
    mouse,
    h("div", { class: "key-sheets" }, ...sheets),
    h("p", { class: "quiet" }, `HexaLab ${tables.version}. `, context.app.host.keeps ? offline(context) : ""),
  ]);
}

/** Whether the viewer is there without a network. @param {import("../widgets/bind.js").Context} context */
function offline(context) {
  const words = h("span");
  const address = new URL("offline/index.html", new URL(context.app.host.root, document.baseURI)).href;
  watch(context, { facts: ["lack"] }, () => {
    const lack = context.facts.get("lack");
    words.textContent = lack
      ? `It does not work without a network: ${lack}. `
      : "It works without a network after one visit. ";
  });
  return h("span", {}, words, h("a", { href: address, target: "_blank" }, "What this browser keeps"));
}
