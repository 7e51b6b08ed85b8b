import { saveFile } from "../app/saving.js";
import { watch } from "../widgets/bind.js";
import { h, setText } from "../widgets/dom.js";
import { numberField } from "../widgets/number_field.js";
import { dialog } from "./dialog.js";

/** An archive of meshes was dropped: pictures and measurements of all of them (SPEC B1). @param {import("../widgets/bind.js").Context} context */
export function batchDialog(context) {
  const { app, facts } = context;
  const size = { width: 1280, height: 960 };
  /** @type {AbortController | null} */
  let running = null;
  const what = h("p");
  const progress = h("p", { class: "quiet", role: "status" });
  const fields = h("div", { class: "fields" }, field("width", "Width"), field("height", "Height"));
  const start = h("button", { type: "button", class: "button button-strong", onclick: run }, "Start");
  const stop = h(
    "button",
    { type: "button", class: "button", hidden: true, onclick: () => running?.abort() },
    "Stop",
  );
  const rest = h(
    "p",
    { class: "quiet" },
    "All are drawn under the present settings, or under those beside a mesh: name.json for name.mesh.",
  );
  const element = dialog("batch", "Batch", [
    what,
    rest,
    fields,
    progress,
    h("div", { class: "dialog-end" }, stop, start),
  ]);

  /** @param {"width" | "height"} side @param {string} label */
  function field(side, label) {
    const one = numberField({
      label,
      digits: 0,
      range: () => [1, 8192, 10],
      write: (value) => void (size[side] = value ?? size[side]),
    });
    one.show(size[side]);
    return h("div", { class: "field" }, h("span", {}, label), one.element);
  }

  async function run() {
    const archive = facts.get("archive");
    if (!archive) return;
    const { name, buffer } = archive;
    running = new AbortController();
    start.disabled = true;
    stop.hidden = false;
    try {
      const report = (/** @type {number} */ done, /** @type {number} */ of, /** @type {string} */ mesh) =>
        setText(progress, `${done} of ${of} done${mesh ? `, ${mesh}` : ""}`);
      const zip = await app.batch.run(buffer, { ...size, signal: running.signal, report });
      saveFile(zip, name.replace(/\.zip$/i, "") + "-hexalab.zip");
    } catch (error) {
      setText(
        progress,
        running.signal.aborted ? "Stopped." : `Stopped: ${error instanceof Error ? error.message : error}`,
      );
    } finally {
      running = null;
      start.disabled = false;
      stop.hidden = true;
    }
  }

  element.addEventListener("close", () => {
    running?.abort();
    facts.set({ archive: null });
  });
  watch(context, { facts: ["archive"] }, () => {
    const archive = facts.get("archive");
    if (!archive) return;
    setText(
      what,
      `${archive.count} meshes in ${archive.name}: a picture and a histogram of each, and one table of measurements.`,
    );
    setText(progress, "");
    if (!element.open) element.showModal();
  });
  return element;
}
