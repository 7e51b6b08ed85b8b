import assert from "node:assert/strict";
import { test } from "node:test";
import { statusFromHash, statusToHash } from "../../../static/viewer/state/link.js";
import { merge } from "../../../static/viewer/state/paths.js";

const DEFAULTS = {
  version: 1,
  mesh: { name: "" },
  filters: { picking: { hidden: [] } },
  colour: { map: "parula" },
};

test("S2: a link's hash carries the status, and merging it into the defaults restores it", async () => {
  const status = merge(DEFAULTS, {
    mesh: { name: "Größe.mesh" },
    filters: { picking: { hidden: [1, 2, 3] } },
  });
  const hash = await statusToHash(status, DEFAULTS);
  assert.match(hash, /^status=[\w-]+$/, "nothing that an address would have to escape");
  assert.deepEqual(merge(DEFAULTS, await statusFromHash(`#${hash}`)), status);
});

test("S2: the hash holds only what differs from the defaults", async () => {
  const partial = await statusFromHash(
    await statusToHash(merge(DEFAULTS, { colour: { map: "jet" } }), DEFAULTS),
  );
  assert.deepEqual(partial, { version: 1, colour: { map: "jet" } });
});

test("S2: ten thousand picked cells stay below 40 kB", async () => {
  const hidden = Array.from({ length: 10000 }, (_, at) => at * 3);
  const hash = await statusToHash(merge(DEFAULTS, { filters: { picking: { hidden } } }), DEFAULTS);
  assert.ok(hash.length < 40000, `${hash.length} characters`);
});

test("S2: no status in the hash is null, a cut one is said to be cut", async () => {
  assert.equal(await statusFromHash(""), null);
  assert.equal(await statusFromHash("#section"), null);
  const hash = await statusToHash(DEFAULTS, { version: 1 });
  await assert.rejects(statusFromHash(hash.slice(0, -6)), /cut short/);
});
