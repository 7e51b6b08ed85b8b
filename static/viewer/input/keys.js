import { VIEWS, zoomedCamera } from "../state/camera.js";
import { toggleTool } from "../state/picking.js";
import { fromView, inverted, planesOf, withPlane } from "../state/planes.js";

/**
 * The keyboard as a table, F3D's keys where they fit. The cheat sheet is made from it.
 *
 * @typedef {import("../app/app.js").App} App
 * @typedef {import("../state/planes.js").Plane} Plane
 * @typedef {{ keys: readonly string[], group: string, what: string, press: (app: App, event: KeyboardEvent) => void }} KeyRow
 *   `keys` as in KeyboardEvent.key, "Ctrl+" before it where that is held
 */

/** @template T @param {readonly T[]} list @param {T} value @returns {T} */
const next = (list, value) => list[(list.indexOf(value) + 1) % list.length];

/** @param {string} section */
function unfold(section) {
  const element = /** @type {HTMLDetailsElement | null} */ (document.getElementById(`section-${section}`));
  if (!element) return;
  element.open = !element.open;
  if (element.open) element.scrollIntoView({ block: "nearest" });
}

/** The field for a number, wherever the panel stands. */
function askForNumber() {
  const field = /** @type {HTMLInputElement | null} */ (document.getElementById("go-to"));
  const section = field?.closest("details");
  if (section) section.open = true;
  field?.focus();
  field?.select();
}

/** @param {import("../state/facts.js").Tool} tool @returns {KeyRow["press"]} */
const take =
  (tool) =>
  ({ facts }) =>
    toggleTool(facts, tool);

/** @param {App} app @param {(plane: Plane) => Partial<Plane>} change @param {import("../state/store.js").SetOptions} [options] */
function changePlane(app, change, options) {
  const { planes, index } = planesOf(app);
  if (planes[index])
    app.store.set(
      { filters: { planes: { enabled: true, items: withPlane(planes, index, change(planes[index])) } } },
      options,
    );
}

/** Milliseconds without another press after which the next one is a step of undo of its own. */
const PAUSE = 600;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let sealing;

/** @param {App["store"]} store */
function sealSoon(store) {
  clearTimeout(sealing);
  sealing = setTimeout(() => store.seal(), PAUSE);
}

/** @param {number} step @returns {KeyRow["press"]} */
const slideBy = (step) => (app) => {
  changePlane(
    app,
    (plane) => ({ offset: Math.min(1, Math.max(0, Math.round((plane.offset + step) * 1000) / 1000)) }),
    { undo: "slide" },
  );
  sealSoon(app.store);
};

/** @param {number} factor of the distance @returns {KeyRow["press"]} */
const zoomBy =
  (factor) =>
  ({ store, scene }) => {
    store.set({ camera: zoomedCamera(scene.camera, factor) }, { undo: "zoom" });
    sealSoon(store);
  };

/** @param {string} name @returns {KeyRow["press"]} */
const look =
  (name) =>
  ({ store }) =>
    void store.set({ camera: VIEWS[name] });

/** @type {readonly KeyRow[]} */
export const KEYS = [
  { group: "Mesh", keys: ["o"], what: "Open a file", press: () => document.getElementById("file")?.click() },
  {
    group: "Mesh",
    keys: ["n"],
    what: "Go to an element or a node by its number",
    press: askForNumber,
  },
  { group: "Mesh", keys: ["PageUp"], what: "Mesh before, in its source", press: (app) => app.openBeside(-1) },
  { group: "Mesh", keys: ["PageDown"], what: "Mesh after, in its source", press: (app) => app.openBeside(1) },
  {
    group: "Mesh",
    keys: ["x"],
    what: "Compare: side by side, curtain",
    press: ({ store, tables, facts }) =>
      facts.get("second") &&
      void store.set({
        compare: { layout: next(tables.choices["compare.layout"], store.status.compare.layout) },
      }),
  },
  {
    group: "Mesh",
    keys: ["w"],
    what: "Compare: each mesh takes the other's place",
    press: ({ comparing }) => void comparing.swap(),
  },
  { group: "Mesh", keys: ["m"], what: "Mesh section: fold, unfold", press: () => unfold("mesh") },
  {
    group: "Filters",
    keys: ["v"],
    what: "Slice from the view; with shift along the nearest axis",
    press: (app, { shiftKey }) =>
      changePlane(app, (plane) => fromView(plane, app.store.status.camera.direction, shiftKey)),
  },
  { group: "Filters", keys: ["f"], what: "Invert the slice", press: (app) => changePlane(app, inverted) },
  { group: "Filters", keys: ["]"], what: "Slice further", press: slideBy(0.01) },
  { group: "Filters", keys: ["["], what: "Slice back", press: slideBy(-0.01) },
  { group: "Filters", keys: ["d"], what: "Dig: click hides a cell (or hold ctrl)", press: take("dig") },
  {
    group: "Filters",
    keys: ["u"],
    what: "Undig: click shows the cell behind (or hold shift)",
    press: take("undig"),
  },
  {
    group: "Filters",
    keys: ["j"],
    what: "Isolate: click hides all other cells",
    press: take("isolate"),
  },
  {
    group: "Filters",
    keys: ["r"],
    what: "Show everything: all filters reset",
    press: (app) => app.views.showAll(),
  },
  {
    group: "Drawing",
    keys: ["e"],
    what: "Separation: next mode",
    press: ({ store, tables }) =>
      void store.set({
        separation: { mode: next(tables.choices["separation.mode"], store.status.separation.mode) },
      }),
  },
  {
    group: "Drawing",
    keys: ["c"],
    what: "Colour: sides, quality, kind",
    press: ({ store, tables }) => {
      const ways = tables.choices["colour.by"].filter(
        (by) => !["attribute", "part", "group", "block", "chosen"].includes(by),
      ); // which the mesh may lack
      store.set({ colour: { by: next(ways, store.status.colour.by) } });
    },
  },
  {
    group: "Drawing",
    keys: ["y"],
    what: "Colour map: next",
    press: ({ store, tables }) =>
      void store.set({ colour: { map: next(tables.choices["colour.map"], store.status.colour.map) } }),
  },
  {
    group: "Drawing",
    keys: ["s"],
    what: "Metric: next",
    press: ({ store, tables }) =>
      void store.set({
        colour: {
          metric: next(
            tables.metrics.map((metric) => metric.id),
            store.status.colour.metric,
          ),
          range: null,
        },
      }),
  },
  {
    group: "Drawing",
    keys: ["i"],
    what: "Irregular edges: next step",
    press: ({ store, tables }) => {
      const [, last] = tables.limits["irregular.mode"];
      store.set({ irregular: { mode: (store.status.irregular.mode + 1) % (last + 1) } });
    },
  },
  {
    group: "Drawing",
    keys: ["q"],
    what: "Ambient occlusion on, off",
    press: ({ store }) =>
      void store.set({
        lighting: { mode: store.status.lighting.mode === "object_space_ao" ? "direct" : "object_space_ao" },
      }),
  },
  { group: "Drawing", keys: ["b"], what: "Quality section: fold, unfold", press: () => unfold("quality") },
  { group: "View", keys: ["1"], what: "From the front", press: look("front") },
  { group: "View", keys: ["3"], what: "From the right", press: look("right") },
  { group: "View", keys: ["7"], what: "From the top", press: look("top") },
  { group: "View", keys: ["9"], what: "Isometric", press: look("isometric") },
  { group: "View", keys: ["2"], what: "From the back", press: look("back") },
  { group: "View", keys: ["4"], what: "From the left", press: look("left") },
  { group: "View", keys: ["8"], what: "From below", press: look("bottom") },
  {
    group: "View",
    keys: ["5"],
    what: "Perspective, orthographic",
    press: ({ store, tables }) =>
      void store.set({
        camera: { projection: next(tables.choices["camera.projection"], store.status.camera.projection) },
      }),
  },
  {
    group: "View",
    keys: ["Enter"],
    what: "Reset the camera",
    press: (app) => app.views.reset(),
  },
  {
    group: "View",
    keys: [".", "Home"],
    what: "Fit what is shown",
    press: (app) => app.views.fitShown(),
  },
  {
    group: "View",
    keys: ["+", "="],
    what: "Nearer",
    press: zoomBy(1 / 1.2),
  },
  {
    group: "View",
    keys: ["-"],
    what: "Further",
    press: zoomBy(1.2),
  },
  { group: "Page", keys: ["Ctrl+z"], what: "Undo", press: ({ store }) => void store.undo() },
  { group: "Page", keys: ["Ctrl+Shift+z", "Ctrl+y"], what: "Redo", press: ({ store }) => void store.redo() },
  {
    group: "Page",
    keys: ["Escape"],
    what: "Back to turning; close the inspector",
    press: (app) => (app.facts.set({ tool: "turn" }), void app.inspect(null)),
  },
];

/** Keys that are not in the table, for the cheat sheet. @type {readonly { group: string, keys: readonly string[], what: string }[]} */
export const OTHER_KEYS = [
  { group: "View", keys: ["Arrows"], what: "Turn the picture that has the focus; with shift, move it" },
  {
    group: "View",
    keys: ["Double click"],
    what: "Make this point the centre; beside the mesh, fit what is shown",
  },
  { group: "Page", keys: ["Ctrl+c"], what: "Copy the settings" },
  { group: "Page", keys: ["Ctrl+v"], what: "Apply settings from the clipboard" },
  { group: "Page", keys: ["?", "h"], what: "This sheet" },
];

/** What a key without a Latin letter on it stands for, by its place: that of the letter on a US keyboard. */
const PLACES = /** @type {Record<string, string>} */ ({
  BracketLeft: "[",
  BracketRight: "]",
  Minus: "-",
  Equal: "=",
});

/** A letter or a digit of a script in which the table has none. */
const OTHER_SCRIPT = /^(?!\p{Script=Latin})[\p{L}\p{Nd}]$/u;

/** @param {Pick<KeyboardEvent, "key" | "code">} event */
function character({ key, code }) {
  if (key.length !== 1) return key;
  const foreign = key > "\x7f" && OTHER_SCRIPT.test(key);
  if (!foreign) return key.toLowerCase();
  return PLACES[code] ?? /^(?:Key|Digit|Numpad)(\w)$/.exec(code)?.[1].toLowerCase() ?? key;
}

/**
 * The name of a pressed key as the table has it; empty for one that is the browser's or the system's. Option and AltGr
 * make signs on many keyboards ("[" is AltGr+8 in Germany): then the sign is what counts, and no key is held.
 *
 * @param {Pick<KeyboardEvent, "key" | "code" | "ctrlKey" | "metaKey" | "shiftKey" | "altKey">} event
 */
export function nameOfKey(event) {
  const { ctrlKey, metaKey, shiftKey, altKey, key } = event;
  if (altKey) return /^[!-/:-@[-`{-~]$/.test(key) && !metaKey ? key : "";
  const held = ctrlKey || metaKey ? `Ctrl+${shiftKey ? "Shift+" : ""}` : "";
  return held + character(event);
}
