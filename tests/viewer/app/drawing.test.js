import assert from "node:assert/strict";
import { test } from "node:test";
import { Drawing } from "../../../static/viewer/app/drawing.js";
import { Messages } from "../../../static/viewer/app/messages.js";
import { Superseded } from "../../../static/viewer/core/client.js";
import { Facts } from "../../../static/viewer/state/facts.js";
import { Look } from "../../../static/viewer/state/look.js";
import { CoreSettings } from "../../../static/viewer/state/core_settings.js";
import { StatusStore } from "../../../static/viewer/state/store.js";

const DEFAULTS = {
  mesh: { name: "" },
  camera: { distance: 1.5 },
  filters: { planes: { items: [] } },
  colour: { by: "sides", map: "parula" },
};

const CORE_PATHS = ["filters", "separation.mode", "colour.by", "colour.range", "irregular"];

/** A core that answers when told, and a scene that keeps what it was given. */
function parts() {
  const store = /** @type {StatusStore<any>} */ (new StatusStore(DEFAULTS));
  const facts = new Facts({ timings: {} });
  /** @type {{ changed: any, lean: boolean, whole: boolean, answer: (value: any) => void, fail: (error: Error) => void }[]} */
  const calls = [];
  /** @type {any[]} */
  const drawn = [];
  /** @type {Record<string, () => void>} */
  const heard = {};
  const note = (/** @type {string} */ name) => (/** @type {any} */ value) => drawn.push([name, value]);
  const scene = {
    setStatus: note("status"),
    setSurface: note("surface"),
    flush() {},
    hurried: false,
    on(/** @type {string} */ name, /** @type {() => void} */ listener) {
      heard[name] = listener;
    },
    setSilhouette: note("silhouette"),
    setOver: (/** @type {string} */ layer, /** @type {unknown} */ record) => note(layer)(record),
    setCellColours: note("colours"),
    showPlane: note("plane"),
  };
  const client = {
    milliseconds: {},
    call: (/** @type {string} */ _, /** @type {() => any[]} */ args) => {
      const [changed, lean, whole] = args();
      return new Promise((answer, fail) => calls.push({ changed, lean, whole, answer, fail }));
    },
  };
  const messages = new Messages(facts);
  const drawing = new Drawing({
    look: new Look(store),
    client: /** @type {any} */ (client),
    scene: /** @type {any} */ (scene),
    facts,
    messages,
    tables: /** @type {any} */ ({ core_paths: CORE_PATHS }),
  });
  drawing.begin();
  drawn.length = 0;
  return { store, facts, calls, drawn, drawing, scene, heard };
}

test("P6: camera and map go to the scene alone; filters and what is coloured by go to the core too", () => {
  const settings = new CoreSettings(CORE_PATHS);
  assert.equal(settings.concern(["camera.distance", "colour.map", "background", "lighting.mode"]), false);
  for (const path of [
    "filters.planes.items",
    "colour.by",
    "colour.range",
    "separation.mode",
    "irregular.mode",
  ]) {
    assert.equal(settings.concern([path]), true, path);
  }
  const { store, calls, drawn } = parts();
  store.set({ camera: { distance: 2 } });
  assert.equal(calls.length, 0);
  assert.equal(drawn[0][1].camera.distance, 2);
  store.set({ colour: { by: "quality" } });
  assert.equal(calls.length, 1);
});

test("only the buffers that the core sends are handed on", async () => {
  const { store, calls, drawn, facts } = parts();
  store.set({ colour: { by: "quality" } });
  calls[0].answer({
    shown_cells: 5,
    shown_faces: 9,
    surface: "S",
    colour: { map_position: "M" },
    max_depth: 3,
  });
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(drawn.slice(1), [["surface", "S"], ["colours", "M"]]); // prettier-ignore
  assert.deepEqual(facts.get("shown"), { cells: 5, faces: 9 });
  assert.equal(facts.get("layers"), 4, "the right end of the peel slider hides everything");
});

test("R8: arrows go to the scene, and what is known of them to the panels", async () => {
  const { store, calls, drawn, drawing, facts } = parts();
  store.set({ filters: { planes: { items: [1] } } });
  const arrows = { inward: new Uint8Array(7), longest: 2.5, not_finite: 1, zero: 3 };
  calls[0].answer({ shown_cells: 5, shown_faces: 9, arrows });
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(drawn.slice(1), [["arrows", arrows]]); // prettier-ignore
  assert.equal(drawing.records.arrows, arrows);
  assert.deepEqual(facts.get("arrows"), { drawn: 7, longest: 2.5, not_finite: 1, zero: 3 });
});

test("V9: a superseded call says nothing, a failed one is a message, and the next good one takes it back", async () => {
  const { store, calls, facts } = parts();
  const settle = () => new Promise((resolve) => setTimeout(resolve));
  store.set({ filters: { planes: { items: [1] } } });
  calls[0].fail(new Superseded());
  await settle();
  assert.equal(facts.get("messages").length, 0);
  store.set({ filters: { planes: { items: [2] } } });
  calls[1].fail(new Error("the core is out of memory"));
  await settle();
  assert.equal(facts.get("messages")[0].text, "the core is out of memory");
  store.set({ filters: { planes: { items: [3] } } });
  calls[2].answer({ shown_cells: 1, shown_faces: 6 });
  await settle();
  assert.equal(facts.get("messages").length, 0);
});

test("P2: a hurried scene gets lean surfaces, and the whole one when it has calmed down, once", async () => {
  const { store, calls, scene, heard } = parts();
  const settle = () => new Promise((resolve) => setTimeout(resolve));
  heard.calm();
  assert.equal(calls.length, 0, "nothing is lacking");
  scene.hurried = true;
  store.set({ filters: { planes: { items: [1] } } });
  assert.equal(calls[0].lean, true);
  scene.hurried = false;
  heard.calm(); // even while the lean answer is on its way
  assert.equal(calls[1].lean, false);
  assert.deepEqual(calls[1].changed, {}, "the lean call took the change with it");
  for (const call of calls) call.answer({ shown_cells: 5, shown_faces: 9 });
  await settle();
  heard.calm();
  assert.equal(calls.length, 2);
});

test("P2: the core is told what has changed since it was told last, and all after another mesh or a failure", async () => {
  const { store, calls, drawing } = parts();
  const settle = () => new Promise((resolve) => setTimeout(resolve));
  const whole = () => ({ filters: store.status.filters, colour: { by: store.status.colour.by } });
  store.set({ filters: { planes: { items: [1] } } });
  assert.deepEqual(calls[0].changed, whole());
  store.set({ colour: { by: "quality" } });
  assert.deepEqual(calls[1].changed, { colour: { by: "quality" } });
  store.set({ colour: { by: "sides", map: "jet" } });
  assert.deepEqual(calls[2].changed, { colour: { by: "sides" } });
  calls[2].fail(new Error("the mesh has no such attribute"));
  await settle();
  store.set({ filters: { planes: { items: [2] } } });
  assert.deepEqual(calls[3].changed, whole());
  drawing.begin();
  void drawing.update();
  assert.deepEqual(calls[4].changed, whole());
});

test("R10: after an answer that failed, or could not be drawn, all records are asked for until they are there", async () => {
  const { store, calls, scene, drawn, facts } = parts();
  const settle = () => new Promise((resolve) => setTimeout(resolve));
  const counts = { shown_cells: 1, shown_faces: 6 };
  store.set({ filters: { planes: { items: [1] } } });
  calls[0].answer({ ...counts, surface: "S" });
  await settle();
  scene.setCellColours = () => {
    throw new RangeError("Array buffer allocation failed");
  };
  store.set({ colour: { by: "quality" } });
  assert.equal(calls[1].whole, false);
  calls[1].answer({ ...counts, colour: { map_position: "M" } });
  await settle();
  assert.equal(facts.get("messages")[0].text, "Array buffer allocation failed");
  scene.setCellColours = (/** @type {any} */ value) => drawn.push(["colours", value]);
  store.set({ colour: { range: [0, 1] } });
  assert.equal(calls[2].whole, true);
  calls[2].fail(new Error("there is not enough memory for that"));
  await settle();
  store.set({ colour: { range: [0, 2] } });
  assert.equal(calls[3].whole, true);
  calls[3].answer({ ...counts, surface: "S", colour: { map_position: "N" } });
  await settle();
  assert.deepEqual(drawn.at(-1), ["colours", "N"]);
  store.set({ colour: { range: [0, 3] } });
  assert.equal(calls[4].whole, false);
});
