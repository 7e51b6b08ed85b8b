import assert from "node:assert/strict";
import { test } from "node:test";
import { Cells } from "../../../static/viewer/app/cells.js";
import { Messages } from "../../../static/viewer/app/messages.js";
import { Superseded } from "../../../static/viewer/core/client.js";
import { Facts } from "../../../static/viewer/state/facts.js";
import { clear } from "../../../static/viewer/state/picking.js";
import { StatusStore } from "../../../static/viewer/state/store.js";

const DEFAULTS = {
  camera: { direction: [0, 0, -1], distance: 1.5 },
  filters: { picking: clear(), groups: clear() },
};

const FOUND = { rows: [41], cell: 41, around: Uint32Array.from([52, 41, 7]), place: [1, 2, 3] };

/** A core that has an answer for each method, and a page that notes what is done to it. @param {Record<string, any>} answers */
function parts(answers) {
  const store = /** @type {StatusStore<any>} */ (new StatusStore(DEFAULTS));
  const facts = new Facts();
  /** @type {any[][]} */
  const asked = [];
  const all = /** @type {Record<string, any>} */ ({
    inspect: { cell: 41, number: 1301, pending: [] },
    cell_view: { centre: [0, 0, 0], size: 1, edges: new Float32Array(0) },
    ...answers,
  });
  const answer = (/** @type {string} */ method, /** @type {any} */ value) => (all[method] = value);
  const client = {
    call: async (/** @type {string} */ method, /** @type {any[]} */ args) => {
      asked.push([method, ...args]);
      const found = all[method];
      if (found instanceof Error) throw found;
      return found;
    },
  };
  const views = {
    flyToShown: async () =>
      store.set({ camera: { ...store.status.camera, distance: 0.3 } }, { undo: "flight" }),
  };
  const scene = { highlight() {}, mark() {} };
  const messages = new Messages(facts);
  const app = /** @type {any} */ ({ store, facts, client, messages, views, scene });
  const said = () => facts.get("messages").map(({ severity, text }) => [severity, text]);
  return { cells: new Cells(app), store, facts, asked, said, answer };
}

test("R11: an element is isolated with what lies around it, inspected and flown to", async () => {
  const { cells, store, facts, asked, said } = parts({ find: FOUND });
  assert.equal(await cells.goTo("cell", 1301), true);
  assert.deepEqual(asked[0], ["find", "cell", 1301, [0, 0, -1]]);
  const { picking } = store.status.filters;
  assert.deepEqual([picking.isolated, picking.shown], [true, [7, 41, 52]]);
  assert.equal(facts.get("cell")?.number, 1301);
  assert.equal(store.status.camera.distance, 0.3);
  assert.deepEqual(said(), []);
});

test("R11: one step of undo leads back, whatever was picked before", async () => {
  const { cells, store, answer } = parts({ find: FOUND });
  const before = { ...clear(), hidden: [3] };
  store.set({ filters: { picking: before } });
  await cells.goTo("cell", 1301);
  answer("find", { ...FOUND, around: Uint32Array.from([9]) });
  await cells.goTo("cell", 1302);
  assert.deepEqual(store.status.filters.picking.shown, [9]);
  store.undo();
  assert.deepEqual(store.status.filters.picking.shown, [7, 41, 52], "the first way is there yet");
  store.undo();
  assert.deepEqual(store.status.filters.picking, before);
  assert.equal(store.status.camera.distance, 1.5);
});

test("R11: a number that is not there is told in the core's words, and nothing moves", async () => {
  const wrong = new Error("the mesh has no element 5: its numbers are from 1,001 to 6,758");
  const { cells, store, said } = parts({ find: wrong });
  assert.equal(await cells.goTo("cell", 5), false);
  assert.deepEqual(said(), [["error", wrong.message]]);
  assert.equal(store.status.filters.picking.isolated, false);
});

test("R11: the next number that is found takes the message back", async () => {
  const answers = /** @type {Record<string, any>} */ ({ find: new Error("the mesh has no element 5") });
  const { cells, said, answer } = parts(answers);
  await cells.goTo("cell", 5);
  assert.equal(said().length, 1);
  answer("find", FOUND);
  await cells.goTo("cell", 1301);
  assert.deepEqual(said(), []);
});

test("R11: a number that several have says so", async () => {
  const { cells, said } = parts({ find: { ...FOUND, rows: [41, 90] } });
  await cells.goTo("vertex", 12);
  assert.deepEqual(said(), [["note", "2 nodes have the number 12: this is the first"]]);
});

test("R11: a node that no element has is told with its place, and nothing is hidden", async () => {
  const lone = { rows: [3], cell: -1, around: new Uint32Array(0), place: [1 / 3, 0, -2] };
  const { cells, store, facts, asked, said } = parts({ find: lone });
  assert.equal(await cells.goTo("vertex", 3), false, "nothing was changed that an undo would bring back");
  assert.deepEqual(said(), [["note", "No element has node 3: it lies at 0.333, 0.000, −2.000"]]);
  assert.equal(store.status.filters.picking.isolated, false);
  assert.equal(facts.get("cell"), null);
  assert.equal(asked.length, 1);
});

test("R11: a newer question says nothing of the one that it replaced", async () => {
  const { cells, said } = parts({ find: new Superseded() });
  await cells.goTo("cell", 1);
  assert.deepEqual(said(), []);
});

test("R11: cells are listed for other programs; what fails is a message and no text", async () => {
  const { cells, asked } = parts({ cell_list: "*ELSET, ELSET=WORST\n7\n" });
  assert.equal(await cells.list([2], "elset", "WORST"), "*ELSET, ELSET=WORST\n7\n");
  assert.deepEqual(asked, [["cell_list", [2], "elset", "WORST"]]);
  const broken = parts({ cell_list: new Error("out of memory") });
  assert.equal(await broken.cells.list([2], "elset", "WORST"), null);
  assert.deepEqual(broken.said(), [["error", "out of memory"]]);
});
