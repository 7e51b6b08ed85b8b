import { saveFile } from "../app/saving.js";
import { watch } from "../widgets/bind.js";
import { counted } from "../state/numbers.js";
import { fileSize } from "../../offline/sizes.js";
import { h, setText } from "../widgets/dom.js";
import { dialog } from "./dialog.js";
import { quantityList } from "./quantity_list.js";
import { WAYS } from "./ways_to_save.js";

/** Save the mesh otherwise than as a picture (SPEC A7, A8). @param {import("../widgets/bind.js").Context} context */
export function saveDialog(context) {
  const { app, facts } = context;
  /** @type {AbortController | null} */
  let running = null;
  const what = h(
    "select",
    { id: "save-what", class: "choice", onchange: show },
    ...WAYS.map(({ id, name }) => h("option", { value: id }, name)),
  );
  const format = h("select", { id: "save-format", class: "choice", onchange: show });
  const formatRow = field("Format", format);
  const said = h("p", { class: "quiet" });
  const quantities = quantityList(context);
  const rows = new Map(WAYS.map((way) => [way.id, way.rows(context)]));
  const result = h("p", { class: "quiet save-result", role: "status" });
  const notes = h("ul", { class: "save-notes" });
  const save = h("button", { type: "button", class: "button button-strong", onclick: run }, "Save");
  const stop = h(
    "button",
    { type: "button", class: "button", hidden: true, onclick: () => running?.abort() },
    "Stop",
  );
  const element = dialog(
    "save",
    "Save",
    [
      field("What", what),
      formatRow,
      said,
      quantities.element,
      ...[...rows.values()].map(({ element: row }) => row),
      result,
      notes,
      h("div", { class: "dialog-end" }, stop, save),
    ],
    begin,
  );

  const way = () => WAYS[what.selectedIndex];

  function begin() {
    setText(result, "");
    notes.replaceChildren();
    quantities.begin();
    for (const row of rows.values()) row.begin();
    show();
  }

  function show() {
    const { formats, quantities: listed, id, words } = way();
    const options = formats(context);
    formatRow.hidden = !options.length;
    if (format.dataset.of !== id) {
      format.dataset.of = id;
      const first = way().first ?? options[0]?.id;
      format.replaceChildren(
        ...options.map((one) => h("option", { value: one.id, selected: one.id === first }, one.name)),
      );
    }
    setText(said, words);
    quantities.show(listed);
    for (const [one, { element: row, show: showRow }] of rows) {
      row.hidden = one !== id;
      showRow(format.value);
    }
    save.disabled = running !== null || !facts.get("shown")?.cells;
  }

  async function run() {
    running = new AbortController();
    save.disabled = what.disabled = format.disabled = true;
    stop.hidden = !way().stops;
    notes.replaceChildren();
    setText(result, "saving…");
    try {
      const {
        file,
        ending,
        notes: lacks,
        part = "",
      } = await way().save(context, {
        format: format.value,
        quantities: quantities.chosen(way().quantities),
        signal: running.signal,
        report: (done, of) => setText(result, `${done} of ${counted(of, "picture")}`),
        ...rows.get(way().id)?.values(),
      });
      const name = `${app.saving.stem}${part}.${ending}`;
      saveFile(file, name);
      setText(result, `Saved: ${name}, ${fileSize(file.size)}`);
      notes.replaceChildren(...lacks.map((note) => h("li", {}, note)));
    } catch (error) {
      setText(
        result,
        running.signal.aborted ? "Stopped." : error instanceof Error ? error.message : String(error),
      );
    } finally {
      running = null;
      what.disabled = format.disabled = false;
      stop.hidden = true;
      show();
    }
  }

  element.addEventListener("close", () => running?.abort());
  watch(context, { facts: ["summary", "shown", "statistics"] }, () => element.open && show());
  return element;
}

/** @param {string} label @param {HTMLElement} control */
function field(label, control) {
  return h("div", { class: "save-field" }, h("label", { for: control.id }, label), control);
}
