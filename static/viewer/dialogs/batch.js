import { saveFile } from "../app/saving.js";
import { watch } from "../widgets/bind.js";
import { count, counted } from "../state/numbers.js";
import { h, setText } from "../widgets/dom.js";
import { numberField } from "../widgets/number_field.js";
import { dialog } from "./dialog.js";

/** Pictures and measurements of many meshes, of an archive or of files (SPEC B1). @param {import("../widgets/bind.js").Context} context */
export function batchDialog(context) {
  const { app, facts } = context;
  const size = { width: 1280, height: 960 };
  /** @type {AbortController | null} */
  let running = null;
  const what = h("p");
  const progress = h("p", { class: "quiet", role: "status" });
  const problems = h("ul", { class: "problems" });
  const figures = h("input", { type: "checkbox", id: "batch-figures" });
  const asFigures = h(
    "label",
    { class: "check", title: "Legend, scale bar, axes, caption, panels: what is set in Save a picture" },
    figures,
    h("span", {}, "As figures, as set in “Save a picture”"),
  );
  const fields = h("div", { class: "fields" }, field("width", "Width"), field("height", "Height"));
  const input = h("input", {
    type: "file",
    multiple: true,
    class: "visually-hidden",
    tabindex: -1,
    "aria-label": "Meshes, or an archive of meshes",
    onchange: () => {
      const files = [...(input.files ?? [])];
      input.value = "";
      if (files.length) void app.offerBatch(files);
    },
  });
  const choose = h(
    "button",
    { type: "button", class: "button", onclick: () => input.click() },
    "Choose meshes…",
  );
  const start = h("button", { type: "button", class: "button button-strong", onclick: run }, "Start");
  const stop = h(
    "button",
    { type: "button", class: "button", hidden: true, onclick: () => running?.abort() },
    "Stop",
  );
  const rest = h(
    "p",
    { class: "quiet" },
    "All are drawn under the present settings, each in its own view where that was not changed; or under those beside a mesh: name.json for name.mesh.",
  );
  const beside = h("p");
  const element = dialog(
    "batch",
    "Pictures of many meshes",
    [
      what,
      beside,
      rest,
      fields,
      asFigures,
      progress,
      problems,
      h("div", { class: "dialog-end" }, choose, input, stop, start),
    ],
    show,
  );

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

  function show() {
    const archive = facts.get("archive");
    start.disabled = !archive || running !== null;
    setText(
      what,
      archive
        ? `${counted(archive.count, "mesh", "meshes")} in ${archive.name}: a picture and a histogram of each, and one table of measurements.`
        : "Choose an archive (.zip) of meshes, or several files: a picture and a histogram of each, and one table of measurements.",
    );
    const compared = facts.get("comparison");
    beside.hidden = !compared;
    setText(beside, compared ? besideInWords(compared) : "");
    setText(progress, "");
    problems.replaceChildren();
  }

  async function run() {
    const archive = facts.get("archive");
    if (!archive) return;
    running = new AbortController();
    start.disabled = choose.disabled = true;
    stop.hidden = false;
    problems.replaceChildren();
    try {
      const { zip, failed } = await app.batch.run(archive.entries, {
        ...size,
        figures: figures.checked,
        signal: running.signal,
        report: (done, of, mesh, failures) => setText(progress, inWords(done, of, mesh, failures)),
      });
      problems.replaceChildren(...failed.map(({ name, problem }) => h("li", {}, `${name}: ${problem}`)));
      saveFile(zip, archive.name.replace(/\.zip$/i, "") + "-hexalab.zip");
    } catch (error) {
      setText(
        progress,
        running.signal.aborted ? "Stopped." : `Stopped: ${error instanceof Error ? error.message : error}`,
      );
    } finally {
      running = null;
      start.disabled = choose.disabled = false;
      stop.hidden = true;
    }
  }

  element.addEventListener("close", () => {
    running?.abort();
    facts.set({ archive: null });
  });
  watch(context, { facts: ["archive"] }, () => {
    if (!facts.get("archive")) return;
    if (element.open) show();
    else element.showModal();
  });
  return element;
}

/** @param {import("../state/answers.js").Compared} compared */
function besideInWords({ name, surface }) {
  const both = surface ? "has that surface over the mesh" : "shows both";
  return `Each is compared with ${name}: its picture ${both}, and the table tells distances and what of each metric has changed.`;
}

/** "3 of 4 done, 1 failed, part.mesh". @param {number} done @param {number} of @param {string} mesh under way @param {number} failures */
function inWords(done, of, mesh, failures) {
  const failed = failures ? `, ${count(failures)} failed` : "";
  return `${count(done - failures)} of ${count(of)} done${failed}${mesh ? `, ${mesh}` : ""}`;
}
