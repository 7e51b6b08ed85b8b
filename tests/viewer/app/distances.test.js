import assert from "node:assert/strict";
import { test } from "node:test";
import { Distances } from "../../../static/viewer/app/distances.js";
import { Messages } from "../../../static/viewer/app/messages.js";
import { Superseded } from "../../../static/viewer/core/client.js";
import { Facts } from "../../../static/viewer/state/facts.js";

/** @param {number} max */
const way = (max) => ({ vertices: 4, max, mean: max / 2, rms: max / 1.5, max_percent: 10 * max });

/**
 * A core that measures some vertices at each question.
 *
 * @param {number} of how many vertices @param {number} share so many at a time @param {[there: number, back?: number]} found largest distances
 */
function core(of, share, [there, back]) {
  let done = 0;
  const asked = /** @type {any[][]} */ ([]);
  const fails = /** @type {Error[]} */ ([]);
  const client = {
    call: async (/** @type {string} */ method, /** @type {any[]} */ args = []) => {
      asked.push([method, ...args]);
      await new Promise((resolve) => setTimeout(resolve));
      const error = fails.shift();
      if (error) throw error;
      if (method === "measure_distance") return { done: (done = Math.min(of, done + share)), of };
      assert.equal(done, of, "facts are asked for when all is measured");
      return { there: way(there), back: back === undefined ? null : way(back) };
    },
  };
  const shares = () => asked.filter(([method]) => method === "measure_distance");
  return { client, asked, fails, shares };
}

/** A page that compares a mesh with a surface, or with a second mesh. @param {ReturnType<typeof core>} first @param {ReturnType<typeof core> | null} [second] */
function page(first, second = null) {
  const facts = new Facts(/** @type {any} */ ({ comparison: { name: "b", diagonal: 8 } }));
  const told = /** @type {(number[] | null)[]} */ ([]);
  facts.on("measuring", (measuring) => told.push(measuring && [measuring.done, measuring.of]));
  const comparing = { matched: Promise.resolve(), second: second && { client: second.client } };
  const messages = new Messages(facts);
  const app = /** @type {any} */ ({ facts, client: first.client, messages });
  const distances = new Distances(app, /** @type {any} */ (comparing));
  const said = () => facts.get("messages").map(({ severity, text }) => [severity, text]);
  return { facts, distances, told, said, comparing };
}

test("S7: the way to a surface and back is measured by the one core, in shares, until all is done", async () => {
  const first = core(10, 4, [0.5, 0.75]);
  const { distances, told, facts } = page(first);
  const apart = await distances.measure();
  assert.deepEqual(first.shares(), Array(3).fill(["measure_distance", true]));
  assert.deepEqual(told, [[4, 10], [8, 10], [10, 10], null]); // prettier-ignore
  assert.deepEqual(first.asked.at(-1), ["distance_facts", true, 8]);
  assert.deepEqual(apart, { a_to_b: way(0.5), b_to_a: way(0.75), hausdorff: 0.75, hausdorff_percent: 7.5 });
  assert.equal(facts.get("apart"), apart);
});

test("S7: of two meshes each core measures its own way, and percents are of the first one's diagonal", async () => {
  const [first, second] = [core(6, 3, [0.5]), core(5, 1, [0.25])];
  const { distances, told, facts } = page(first, second);
  const apart = await distances.measure();
  assert.deepEqual(first.shares(), Array(2).fill(["measure_distance", false]));
  assert.deepEqual(second.shares(), Array(5).fill(["measure_distance", false]));
  for (const { asked } of [first, second]) assert.deepEqual(asked.at(-1), ["distance_facts", false, 8]);
  assert.deepEqual(apart, { a_to_b: way(0.5), b_to_a: way(0.25), hausdorff: 0.5, hausdorff_percent: 5 });
  const counts = told.slice(0, -1).map((one) => /** @type {number[]} */ (one));
  assert.deepEqual(counts.at(-1), [11, 11], "vertices of both are counted together");
  for (let k = 1; k < counts.length; k++) assert.ok(counts[k][0] >= counts[k - 1][0]);
  assert.equal(facts.get("measuring"), null);
});

test("S7: the larger of both largest distances is told, whichever way it is", async () => {
  for (const [there, back] of /** @type {const} */ ([
    [1, 3],
    [3, 1],
  ])) {
    const apart = await page(core(1, 1, [there]), core(1, 1, [back])).distances.measure();
    assert.deepEqual([apart?.a_to_b.max, apart?.b_to_a.max, apart?.hausdorff], [there, back, 3]);
  }
});

test("S7: it is measured once, however often it is asked for", async () => {
  const first = core(3, 1, [1, 1]);
  const { distances } = page(first);
  const [one, other] = await Promise.all([distances.measure(), distances.measure()]);
  assert.equal(one, other);
  assert.equal(await distances.measure(), one);
  assert.equal(first.shares().length, 3);
});

test("S7: it waits until both meshes know of each other, and without a comparison it is null", async () => {
  const first = core(2, 2, [1, 1]);
  const { distances, comparing, facts } = page(first);
  facts.set({ comparison: null });
  let know = () => {};
  comparing.matched = new Promise((resolve) => (know = resolve));
  const measured = distances.measure();
  await new Promise((resolve) => setTimeout(resolve));
  assert.equal(first.asked.length, 0);
  facts.set({ comparison: /** @type {any} */ ({ diagonal: 8 }) });
  know();
  assert.equal((await measured)?.hausdorff, 1);
  const nothing = page(first);
  nothing.facts.set({ comparison: null });
  assert.equal(await nothing.distances.measure(), null);
});

test("S7: forgotten while it is measured, it is null and nothing is told; then it can be measured anew", async () => {
  const first = core(50, 1, [1, 2]);
  const { distances, facts, said } = page(first);
  const measured = distances.measure();
  await new Promise((resolve) => facts.on("measuring", resolve));
  assert.ok(facts.get("measuring"));
  distances.forget();
  assert.equal(facts.get("measuring"), null);
  const until = first.asked.length;
  assert.equal(await measured, null);
  assert.ok(first.asked.length <= until + 1, "no more shares are asked for");
  assert.deepEqual([facts.get("apart"), facts.get("measuring"), said()], [null, null, []]);
  assert.equal((await distances.measure())?.hausdorff, 2);
});

test("S7: what was measured goes when it is forgotten", async () => {
  const { distances, facts } = page(core(1, 1, [1, 1]));
  await distances.measure();
  distances.forget();
  assert.equal(facts.get("apart"), null);
});

test("S7: an error is said, and it can be measured again", async () => {
  const first = core(3, 1, [1, 1]);
  const { distances, facts, said } = page(first);
  first.fails.push(new Error("out of memory"));
  assert.equal(await distances.measure(), null);
  assert.deepEqual(said(), [["error", "out of memory"]]);
  assert.deepEqual([facts.get("apart"), facts.get("measuring")], [null, null]);
  assert.equal((await distances.measure())?.hausdorff, 1);
});

test("S7: an error at one mesh ends the measuring at the other", async () => {
  const [first, second] = [core(1e6, 1, [1]), core(1, 1, [1])];
  const { distances, said } = page(first, second);
  second.fails.push(new Error("out of memory"));
  assert.equal(await distances.measure(), null);
  await new Promise((resolve) => setTimeout(resolve, 10));
  const until = first.asked.length;
  await new Promise((resolve) => setTimeout(resolve, 10));
  assert.equal(first.asked.length, until);
  assert.deepEqual(said(), [["error", "out of memory"]]);
});

test("S7: an error of surfaces that have gone meanwhile is no news, nor is a question that another replaced", async () => {
  const gone = core(3, 1, [1, 1]);
  const one = page(gone);
  gone.fails.push(new Error("The core was closed."));
  const measured = one.distances.measure();
  await Promise.resolve();
  one.distances.forget();
  assert.equal(await measured, null);
  assert.deepEqual(one.said(), []);
  const replaced = core(3, 1, [1, 1]);
  const other = page(replaced);
  replaced.fails.push(new Superseded());
  assert.equal(await other.distances.measure(), null);
  assert.deepEqual(other.said(), []);
});

test("S7: distances that can't be saved are said to be", async () => {
  const first = core(1, 1, [1, 1]);
  const { distances, said } = page(first);
  first.fails.push(new Error("the mesh is compared with nothing"));
  await distances.save();
  assert.deepEqual(said(), [["error", "the mesh is compared with nothing"]]);
});
