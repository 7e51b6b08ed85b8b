import { KEYS, nameOfKey } from "./keys.js";
import { isTyping } from "./typing.js";

/** Controls that use Enter themselves. */
const PRESSABLE = "button, a, summary, input, select";

/** Keys that scroll the panel, and go to the end of a slider. */
const MOVES = ["PageUp", "PageDown", "Home"];

/** @param {import("../app/app.js").App} app @param {{ showModal: () => void }} help the cheat sheet */
export function listenToKeys(app, help) {
  window.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || isTyping(event.target) || document.querySelector("dialog[open]")) return;
    const target = /** @type {Element} */ (event.target);
    if (event.key === "Enter" && target.matches?.(PRESSABLE)) return;
    if (MOVES.includes(event.key) && target.closest?.("#panel")) return;
    const name = nameOfKey(event);
    if (name === "?" || name === "h") {
      event.preventDefault();
      help.showModal();
      return;
    }
    const row = KEYS.find(({ keys }) => keys.includes(name));
    if (!row) return;
    event.preventDefault();
    row.press(app, event);
  });
}
