import assert from "node:assert/strict";
import { test } from "node:test";
import { posed } from "../../../static/viewer/app/posing.js";
import { Facts } from "../../../static/viewer/state/facts.js";
import { StatusStore } from "../../../static/viewer/state/store.js";

/** What is told of settings while and after they are posed. */
function studio() {
  const store = /** @type {StatusStore<any>} */ (new StatusStore({ peel: { depth: 0 }, silhouette: 1 }));
  const facts = new Facts(/** @type {any} */ ({ posing: false }));
  const app = /** @type {any} */ ({ store, facts, drawing: { drawn: async () => {} } });
  /** @type {string[]} */
  const told = [];
  store.on("*", (_, changed) => void (facts.get("posing") || told.push(...changed)));
  return { app, store, facts, told };
}

const depths = (/** @type {number[]} */ ...all) =>
  /** @type {any[]} */ (all.map((depth) => ({ peel: { depth } })));

test("settings are what they were, after a failure too, and nothing is told of them", async () => {
  const { app, store, facts, told } = studio();
  const taken = await posed(app, depths(1, 2), async () => store.status.peel.depth);
  assert.deepEqual(taken, [1, 2]);
  await assert.rejects(
    posed(app, depths(3), async () => {
      throw new Error("no picture");
    }),
  );
  assert.equal(store.status.peel.depth, 0);
  assert.equal(facts.get("posing"), false);
  assert.equal(store.canUndo, false);
  assert.deepEqual(told, []);
});

test("a pose within a pose ends within it", async () => {
  const { app, store, facts, told } = studio();
  const taken = await posed(app, depths(1, 2), () =>
    posed(app, /** @type {any} */ ([{ silhouette: 0 }]), async () => {
      const { peel, silhouette } = store.status;
      return [peel.depth, silhouette];
    }),
  );
  assert.deepEqual(taken, [[[1, 0]], [[2, 0]]]);
  assert.deepEqual(store.status, { peel: { depth: 0 }, silhouette: 1 });
  assert.equal(facts.get("posing"), false);
  assert.deepEqual(told, []);
});
