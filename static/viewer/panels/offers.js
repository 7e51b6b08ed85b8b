import { fill } from "../widgets/choice.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/**
 * Choose among several meshes that the core has at hand, such as the files that `hexalab view` was given.
 *
 * @param {Context} context
 */
export function offersChooser(context) {
  const { facts, app } = context;
  const files = h("select", {
    id: "offered-mesh",
    class: "choice",
    onchange: () => app.offered?.open(files.value).catch(show), // said in a message by whoever failed
  });
  const row = h(
    "div",
    { class: "row row-wide" },
    h("label", { class: "row-label", for: files.id }, "File"),
    files,
  );

  /** What is on the screen. */
  function show() {
    const offers = facts.get("offers").filter(({ surface }) => !surface);
    const offered = facts.get("offered");
    const other = facts.get("summary") && offered === null ? facts.get("summary")?.name : "";
    row.hidden = offers.length < 2;
    fill(files, [
      ...(offered === null ? [{ value: "", name: other ? `File: ${other}` : "Choose a file…" }] : []),
      ...offers.map(({ id, name }) => ({ value: id, name })),
    ]);
    files.value = offered ?? "";
  }
  watch(context, { facts: ["offers", "offered", "summary"] }, show);
  return row;
}
