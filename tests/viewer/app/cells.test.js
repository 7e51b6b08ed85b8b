import assert from "node:assert/strict";
import { test } from "node:test";
import { Cells } from "../../../static/viewer/app/cells.js";
import { Facts } from "../../../static/viewer/state/facts.js";
import { StatusStore } from "../../../static/viewer/state/store.js";

/** A core that knows sizes after some shares, and keeps what it was asked. */
function parts(/** @type {object} */ colour, shares = 3) {
  /** @type {any[][]} */
  const asked = [];
  const store = /** @type {StatusStore<any>} */ (new StatusStore({ colour, structure: { explode: 0 } }));
  const attributes = [{ id: "point:flow", name: "flow, magnitude" }];
  const facts = new Facts(/** @type {any} */ ({ summary: { attributes }, hover: { cell: 7 } }));
  let left = shares;
  const answers = {
    inspect: (/** @type {number} */ cell) => ({ cell, pending: left > 0 ? ["shape_and_size"] : [] }),
    value: (/** @type {number} */ cell, /** @type {string} */ id) =>
      id === "shape_and_size"
        ? { cell, kind: "hexahedron", value: left > 0 ? null : 0.5, components: null, pending: left > 0 }
        : { cell, kind: "hexahedron", value: 5, components: [3, 4, 0], pending: false },
    cell_view: () => ({ centre: [0, 0, 0], size: 1, edges: new Float32Array(0) }),
    measure_sizes: () => --left <= 0,
  };
  const client = {
    call: async (/** @type {keyof answers} */ method, /** @type {any[]} */ args = []) => {
      asked.push([method, ...args]);
      await new Promise((resolve) => setTimeout(resolve));
      return /** @type {any} */ (answers[method])(...args);
    },
  };
  const tables = {
    traced: [],
    compared: [],
    metrics: [{ id: "shape_and_size", name: "Shape and Size", symbol: "SHS" }],
  };
  const said = /** @type {any[]} */ ([]);
  const messages = { settle: () => {}, error: (/** @type {any} */ error) => said.push(error) };
  const scene = { highlight() {}, mark() {} };
  const app = /** @type {any} */ ({ store, facts, client, tables, messages, scene });
  return { cells: new Cells(app), asked, facts, said, store };
}

const BY_FLOW = { by: "attribute", attribute: "point:flow", metric: "" };
const BY_SIZE = { by: "quality", attribute: "", metric: "shape_and_size" };

test("V7: the pointer asks for the one value that is looked at, an attribute of points as well", async () => {
  const { cells, asked, facts } = parts(BY_FLOW);
  await cells.tell(7);
  assert.deepEqual(asked, [["value", 7, "point:flow"]]);
  const { name, value, components } = facts.get("hover") ?? {};
  assert.deepEqual([name, value, components], ["flow, magnitude", 5, [3, 4, 0]]);
});

test("V7: a size that waits for the mesh's mean volume is told when that is known", async () => {
  const { cells, asked, facts } = parts(BY_SIZE);
  await cells.tell(7);
  assert.deepEqual(
    asked.map(([method]) => method),
    ["value", "measure_sizes", "measure_sizes", "measure_sizes", "value"],
  );
  assert.equal(facts.get("hover")?.value, 0.5);
});

test("V7: the inspector shows a cell at once, and its sizes when they are known", async () => {
  const { cells, facts, asked } = parts(BY_SIZE, 2);
  /** @type {any[]} */
  const shown = [];
  facts.on("cell", (cell) => shown.push(cell?.pending));
  await cells.inspect(7);
  assert.deepEqual(shown, [["shape_and_size"], []]);
  assert.deepEqual(
    asked.map(([method]) => method),
    ["inspect", "cell_view", "measure_sizes", "measure_sizes", "inspect"],
  );
});

test("V7: another mesh ends the measuring of the one before", async () => {
  const { cells, facts, asked, said } = parts(BY_SIZE, 1e9);
  const inspected = cells.inspect(7);
  await new Promise((resolve) => setTimeout(resolve, 5));
  await cells.inspect(null);
  facts.set({ summary: null });
  await inspected;
  const count = asked.length;
  await new Promise((resolve) => setTimeout(resolve, 5));
  assert.equal(asked.length, count);
  assert.deepEqual(said, []);
});

test("T4: the inspected cell is outlined where it stands when blocks are drawn apart", async () => {
  const { cells, asked, store } = parts(BY_FLOW, 0);
  store.set({ structure: { explode: 0.2 } });
  await new Promise((resolve) => setTimeout(resolve, 5));
  assert.deepEqual(asked, [], "no cell is inspected");
  await cells.inspect(7);
  asked.length = 0;
  store.set({ structure: { explode: 0.5 } });
  await new Promise((resolve) => setTimeout(resolve, 5));
  assert.deepEqual(asked, [["cell_view", 7]]);
});
