import assert from "node:assert/strict";
import { test } from "node:test";
import { CoreSettings } from "../../../static/viewer/state/core_settings.js";
import { merge } from "../../../static/viewer/state/paths.js";
import { StatusStore } from "../../../static/viewer/state/store.js";

const PATHS = ["filters", "separation.mode", "silhouette", "colour.range"];
const DEFAULTS = {
  camera: { distance: 1 },
  filters: { peel: { depth: 0 }, picking: { hidden: [], shown: [] } },
  separation: { mode: "lines", line_width: 1 },
  silhouette: 1,
  colour: { map: "parula", range: null },
};

/** @param {any} status */
const corePart = ({ filters, separation, silhouette, colour }) => ({
  filters,
  separation: { mode: separation.mode },
  silhouette,
  colour: { range: colour.range },
});

test("what the core was told adds up to its part of the status, whatever was told when", () => {
  const store = /** @type {StatusStore<any>} */ (new StatusStore(DEFAULTS));
  const settings = new CoreSettings(PATHS);
  let held = settings.changed(store.status);
  assert.deepEqual(held, corePart(DEFAULTS));
  let seed = 7;
  const random = (/** @type {number} */ below) =>
    (seed = (seed * 16807) % 2147483647) % below; // prettier-ignore
  for (let turn = 0; turn < 500; turn++) {
    const change = [
      { filters: { peel: { depth: random(3) } } },
      { filters: { picking: { hidden: Array.from({ length: random(4) }, () => random(9)) } } },
      { separation: { mode: ["lines", "fissure"][random(2)], line_width: random(5) } },
      { silhouette: random(2), camera: { distance: random(9) } },
      { colour: { range: random(2) ? null : [0, random(5)], map: ["jet", "parula"][random(2)] } },
    ][random(5)];
    store.set(change);
    if (random(8) === 0) store.undo();
    if (random(2)) continue; // a call that another replaced was never sent
    if (random(20) === 0) settings.forget();
    held = merge(held, settings.changed(store.status));
    assert.deepEqual(held, corePart(store.status));
  }
});

test("P2: lists that did not change are not told again", () => {
  const store = /** @type {StatusStore<any>} */ (new StatusStore(DEFAULTS));
  const settings = new CoreSettings(PATHS);
  store.set({ filters: { picking: { hidden: Array.from({ length: 100_000 }, (_, cell) => cell) } } });
  assert.equal(settings.changed(store.status).filters.picking.hidden.length, 100_000);
  store.set({ filters: { peel: { depth: 2 } } });
  assert.deepEqual(settings.changed(store.status), { filters: { peel: { depth: 2 } } });
  assert.deepEqual(settings.changed(store.status), {});
});
