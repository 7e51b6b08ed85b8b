import { saveFile } from "../app/saving.js";
import { safeStem } from "../files/names.js";
import { optionsOf } from "../state/choices.js";
import { PANELS } from "../state/panels.js";
import { parsed, typed } from "../state/numbers.js";
import { watch } from "../widgets/bind.js";
import { buttons, wholeNumber } from "../widgets/controls.js";
import { h, setText } from "../widgets/dom.js";
import { renderControl } from "../widgets/section.js";
import { dialog } from "./dialog.js";

/**
 * @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../widgets/bind.js").Control} Control
 * @typedef {import("../app/figures.js").FigureFormat} FigureFormat
 */

/** @type {readonly FigureFormat[]} */
const FORMATS = ["png", "svg", "pdf"];

/** Milliseconds that a setting has to rest before the preview follows. */
const REST = 250;

/** @param {Context} context */
const figureOf = ({ store }) => store.status.figure;

/** One side; while none is typed, the box shows what it follows from the screen to be. @param {"width" | "height"} side @returns {import("../widgets/bind.js").NumberField} */
const sideField = (side) => ({
  name: side,
  optional: true,
  placeholder: (context) => {
    const { [side]: pixels } = context.app.figures.size(context.app.figures.shown);
    const { unit, resolution } = figureOf(context);
    return typed(unit === "mm" ? (pixels / resolution) * 25.4 : pixels, 1);
  },
  read: (context) => figureOf(context)[side],
  write: (value) => ({ figure: { [side]: value } }),
});

/** @param {string} text @param {string} name @param {import("../state/status.js").PartialStatus["figure"]} figure @returns {import("../widgets/bind.js").Action} */
const sizeButton = (text, name, figure) => ({
  name,
  text,
  press: ({ store }) => store.set({ figure }),
});

/** @param {string} id @param {string} label @param {string} hint @returns {Control} */
const toggle = (id, label, hint) => ({
  kind: "toggle",
  id: `figure-${id}`,
  label,
  hint,
  path: `figure.${id}`,
});

/** Where a part that can be switched on stands. @param {"legend" | "scale_bar" | "axes"} part @returns {Control} */
const place = (part) => ({
  kind: "choice",
  id: `figure-${part}-place`,
  label: "",
  path: `figure.${part}_place`,
  status: [`figure.${part}`],
  options: optionsOf(/** @type {"figure.axes_place"} */ (`figure.${part}_place`)),
  hidden: (context) => ["none", false].includes(figureOf(context)[part]),
});

/** @param {Context} context */
const alone = ({ facts }) => facts.get("second") === null;

/** Sizes in millimetres are those of a column and of a page of most journals. @type {readonly Control[]} */
const CONTROLS = [
  buttons({
    label: "Size",
    full: true,
    items: [
      sizeButton("As shown", "As large as on the screen", { unit: "px", width: null, height: null }),
      {
        name: "Twice as large as on the screen",
        text: "2×",
        press: ({ store, app }) => store.set({ figure: times(app.figures.shown, 2) }),
      },
      {
        name: "Four times as large as on the screen",
        text: "4×",
        press: ({ store, app }) => store.set({ figure: times(app.figures.shown, 4) }),
      },
      sizeButton("Column", "A column of a journal, 85 mm", { unit: "mm", width: 85, height: null }),
      sizeButton("Page", "The width of a page, 175 mm", { unit: "mm", width: 175, height: null }),
    ],
  }),
  {
    kind: "choice",
    id: "figure-unit",
    label: "Unit",
    path: "figure.unit",
    options: optionsOf("figure.unit"),
  },
  {
    kind: "numbers",
    id: "figure-size",
    label: "Width, height",
    status: ["figure", "compare"],
    facts: ["canvas", "second"],
    digits: 1,
    items: [sideField("width"), sideField("height")],
  },
  wholeNumber({
    id: "figure-resolution",
    label: "Resolution",
    hint: "Dots per inch",
    path: "figure.resolution",
    status: ["figure.unit"],
    range: [72, 1200, 1],
    hidden: (context) => figureOf(context).unit !== "mm",
  }),
  wholeNumber({
    id: "figure-letters",
    label: "Letters",
    hint: "Size in points",
    path: "figure.letters",
    range: [6, 24, 1],
  }),
  wholeNumber({
    id: "figure-margin",
    label: "Margin",
    hint: "In points",
    path: "figure.margin",
    range: [0, 40, 1],
  }),
  toggle("transparent", "Transparent", "Nothing behind the mesh"),
  toggle("crop", "Crop", "What is empty around the mesh is cut off"),
  {
    kind: "choice",
    id: "figure-legend",
    label: "Legend",
    path: "figure.legend",
    options: optionsOf("figure.legend"),
  },
  place("legend"),
  {
    kind: "text",
    id: "figure-legend-title",
    label: "Title",
    hint: "its own name",
    status: ["figure.legend"],
    read: (context) => figureOf(context).legend_title,
    write: (text) => ({ figure: { legend_title: text } }),
    hidden: (context) => figureOf(context).legend === "none",
  },
  toggle(
    "scale_bar",
    "Scale bar",
    "A length in the file's unit; in perspective, at the distance of the middle",
  ),
  place("scale_bar"),
  toggle("axes", "Axes", "The directions of x, y and z"),
  place("axes"),
  toggle("caption", "Caption", "The mesh and its reference, or what you type"),
  {
    kind: "text",
    id: "figure-caption-text",
    label: "",
    hint: "the mesh and its reference",
    status: ["figure.caption"],
    read: (context) => figureOf(context).caption_text,
    write: (text) => ({ figure: { caption_text: text } }),
    hidden: (context) => !figureOf(context).caption,
  },
  {
    kind: "choice",
    id: "figure-meshes",
    label: "Meshes",
    hint: "Both in one picture, or a file for each under the same settings",
    path: "figure.meshes",
    facts: ["second"],
    options: optionsOf("figure.meshes"),
    hidden: alone,
  },
  {
    kind: "toggle",
    id: "figure-mesh-names",
    label: "Names",
    hint: "The meshes' names below their pictures",
    path: "compare.labels",
    facts: ["second"],
    hidden: alone,
  },
  {
    kind: "choice",
    id: "figure-panels",
    label: "Panels",
    hint: "Several pictures that differ by one setting",
    status: ["figure.panels"],
    options: optionsOf("figure.panels.setting"),
    read: (context) => figureOf(context).panels.setting,
    write: (chosen) => {
      const setting = /** @type {import("../state/status.js").Status["figure"]["panels"]["setting"]} */ (
        chosen
      );
      return {
        figure: { panels: { setting, values: setting === "none" ? [] : [...PANELS[setting].values] } },
      };
    },
  },
  {
    kind: "text",
    id: "figure-panel-values",
    label: "Values",
    hint: "two to six numbers",
    status: ["figure.panels"],
    hidden: (context) => figureOf(context).panels.setting === "none",
    read: (context) => figureOf(context).panels.values.join(", "),
    check: (text) => (numbersIn(text) ? "" : "two to six numbers, such as 0, 1, 2"),
    write: (text) => ({ figure: { panels: { values: numbersIn(text) ?? [] } } }),
  },
  {
    kind: "toggle",
    id: "figure-panel-letters",
    label: "a) b) c)",
    path: "figure.panels.labels",
    status: ["figure.panels"],
    hidden: (context) => figureOf(context).panels.setting === "none",
  },
];

/** @param {import("../widgets/bind.js").Size} shown @param {number} factor */
function times({ width, height }, factor) {
  const unit = /** @type {const} */ ("px");
  return { unit, width: Math.round(width * factor), height: Math.round(height * factor) };
}

/** @param {string} text @returns {number[] | null} */
function numbersIn(text) {
  const numbers = text
    .split(/[,;\s]+/)
    .filter(Boolean)
    .map(parsed);
  const known = numbers.filter((one) => one !== null);
  return known.length === numbers.length && known.length >= 2 && known.length <= 6 ? known : null;
}

/**
 * Save a picture, or a figure with legend, scale bar, axes, caption, and several pictures in a row (SPEC S5). What will be
 * saved is shown.
 *
 * @param {Context} context
 */
export function imageDialog(context) {
  const { app } = context;
  const preview = h("img", { class: "figure-preview", alt: "The figure as it will be saved", hidden: true });
  const size = h("p", { class: "quiet figure-size", role: "status" });
  const many = h(
    "button",
    {
      type: "button",
      class: "button",
      onclick: () => {
        element.close();
        /** @type {HTMLDialogElement} */ (document.getElementById("batch")).showModal();
      },
    },
    "Of many meshes…",
  );
  const saves = FORMATS.map((format) =>
    h(
      "button",
      {
        type: "button",
        class: `button${format === "png" ? " button-strong" : ""}`,
        onclick: () => save(format),
      },
      `Save ${format.toUpperCase()}`,
    ),
  );
  const element = dialog(
    "image",
    "Save a picture",
    [
      h(
        "div",
        { class: "figure" },
        h("div", { class: "figure-stage" }, preview, size),
        h("div", { class: "figure-controls" }, ...CONTROLS.map((one) => renderControl(context, one))),
      ),
      h(
        "p",
        { class: "quiet" },
        "A PNG carries the settings: dropped on this page, it brings the view back.",
      ),
      h("div", { class: "dialog-end" }, many, ...saves),
    ],
    () => void show(),
  );
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let resting;
  /** @type {Promise<void>} */
  let showing = Promise.resolve();

  /** @param {FigureFormat} format */
  async function save(format) {
    for (const button of saves) button.disabled = true;
    try {
      for (const { which, stem } of files())
        saveFile(await app.figures.file(format, null, which), `${stem}.${format}`);
      element.close();
    } catch (error) {
      say(error);
    } finally {
      for (const button of saves) button.disabled = false;
    }
  }

  /** The files that are saved, of which one is shown: two meshes may go into one, or each into its own. */
  function files() {
    const second = context.facts.get("second");
    const { stem } = app.saving;
    const apart = second && figureOf(context).meshes === "apart";
    if (!apart) return [{ which: /** @type {const} */ ("both"), stem: second ? `${stem}-compared` : stem }];
    return [
      { which: /** @type {const} */ ("first"), stem: `${stem}-A` },
      { which: /** @type {const} */ ("second"), stem: `${safeStem(second.get("summary")?.name ?? "")}-B` },
    ];
  }

  /** One preview at a time, the newest settings last. */
  function show() {
    showing = showing.then(draw);
    return showing;
  }

  async function draw() {
    if (!element.isConnected) return;
    try {
      size.textContent = "drawing…";
      const blob = await app.figures.file("png", null, files()[0].which);
      const { width, height } = app.figures.lastSize;
      const address = URL.createObjectURL(blob);
      preview.onload = () => URL.revokeObjectURL(address);
      preview.src = address;
      preview.hidden = false;
      setText(size, sizeInWords(context, width, height));
    } catch (error) {
      say(error);
    }
  }

  /** @param {unknown} error */
  function say(error) {
    setText(size, error instanceof Error ? error.message : String(error));
  }

  watch(context, { status: ["figure", "compare"] }, () => {
    clearTimeout(resting);
    if (element.open) resting = setTimeout(() => void show(), REST);
  });
  return element;
}

/** "1004 × 755 pixels, 85.0 × 63.9 mm". @param {Context} context @param {number} width @param {number} height */
function sizeInWords(context, width, height) {
  const { unit, resolution } = figureOf(context);
  const pixels = `${width} × ${height} pixels`;
  if (unit === "px") return pixels;
  const millimetres = [width, height].map((side) => ((side / resolution) * 25.4).toFixed(1));
  return `${pixels}, ${millimetres.join(" × ")} mm`;
}
