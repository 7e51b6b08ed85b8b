import assert from "node:assert/strict";
import { test } from "node:test";
import { Measures } from "../../../static/viewer/app/measures.js";
import { Messages } from "../../../static/viewer/app/messages.js";
import { Facts } from "../../../static/viewer/state/facts.js";
import { Look } from "../../../static/viewer/state/look.js";
import { StatusStore } from "../../../static/viewer/state/store.js";

const DEFAULTS = {
  unit: "none",
  colour: { by: "sides", metric: "volume", attribute: "", range: null },
  histogram: { bins: 10 },
};

test("R11: the file's numbers are known before statistics and worst cells are asked for, which tell them", async () => {
  const store = /** @type {StatusStore<any>} */ (new StatusStore(DEFAULTS));
  const facts = new Facts({ core: "ready", summary: /** @type {any} */ ({ cells: 2, attributes: [] }) });
  /** @type {string[]} */
  const asked = [];
  const answers = /** @type {Record<string, any>} */ ({
    numbers: { first: 1, cells: Int32Array.from([1043, 7]) },
    quality: { min: 0, max: 1, percentiles: {} },
    histogram: { quantity: "volume", low: 0, high: 1 },
    worst: { cells: [1], values: [0], places: [[0, 0, 0]], not_finite: [] },
    describe: { groups: [] },
  });
  const client = {
    milliseconds: {},
    call: async (/** @type {string} */ method) => {
      asked.push(method);
      return answers[method];
    },
  };
  const tables = { metrics: [{ id: "volume", name: "Volume" }], compared: [], described: ["groups"] };
  const drawing = { update: async () => {} };
  const messages = new Messages(facts);
  const look = new Look(store);
  const app = /** @type {any} */ ({ store, look, facts, client, tables, drawing, messages, note() {} });
  await new Measures(app).fill();
  assert.deepEqual(asked, ["numbers", "quality", "histogram", "worst", "describe"]);
  const numbering = facts.get("numbering");
  assert.deepEqual(
    facts.get("worst")?.cells.map((row) => numbering.of(row)),
    [7],
  );
  assert.deepEqual(facts.get("description")?.groups, []);
});
