import assert from "node:assert/strict";
import { test } from "node:test";
import { match } from "../../../static/viewer/app/matching.js";
import { Facts } from "../../../static/viewer/state/facts.js";

const SURFACE = {
  points: Float64Array.of(0, 1, 0, 0, 0, 1, 0, 0, 0),
  triangles: Int32Array.of(0, 1, 2),
};

/**
 * A mesh whose core notes what it is asked, and takes blocks away from whoever sends them as a worker does.
 *
 * @param {string} name @param {{ offered?: string | null, mark?: string }} [more]
 */
function side(name, { offered = null, mark = "cells" } = {}) {
  const asked = /** @type {any[][]} */ ([]);
  const block = new Float64Array(20); // answers lie in one block, packed
  block.set(SURFACE.points, 4);
  const coordinates = block.subarray(4, 13);
  const client = {
    call: async (/** @type {string} */ method, /** @type {any[]} */ args = []) => {
      const transfer = args.filter((one) => one instanceof ArrayBuffer);
      asked.push([method, ...structuredClone(args, { transfer })]);
      await new Promise((resolve) => setTimeout(resolve));
      if (method === "fingerprint") return mark;
      if (method === "hand_over")
        return {
          name,
          vertices: 3,
          cells: 1,
          volume: 2,
          points: block.subarray(4, 13),
          triangles: SURFACE.triangles,
          coordinates: args[0] === mark ? coordinates : null,
        };
      return { name: `what ${name} is compared with` };
    },
  };
  const facts = new Facts({ offered });
  return { one: /** @type {any} */ ({ facts, client }), asked, block };
}

const always = () => true;

test("S6: meshes that are both offered are compared by what each core has at hand, and nothing is handed over", async () => {
  const [a, b] = [side("A", { offered: "0" }), side("B", { offered: "1" })];
  const told = await match(a.one, b.one, always);
  assert.deepEqual(a.asked, [["compare_with_offered", "1", true]]);
  assert.deepEqual(b.asked, [["compare_with_offered", "0", false]]);
  assert.equal(told?.name, "what A is compared with");
});

test("S6: else each is told of the other by what the other hands over, and which of both is the second", async () => {
  for (const offered of [
    [null, null],
    ["0", null],
    [null, "1"],
  ]) {
    const [a, b] = [side("A", { offered: offered[0] }), side("B", { offered: offered[1] })];
    const told = await match(a.one, b.one, always);
    for (const [{ asked }, other, second] of /** @type {const} */ ([
      [a, "B", true],
      [b, "A", false],
    ])) {
      assert.deepEqual(
        asked.map(([method]) => method),
        ["fingerprint", "hand_over", "compare_with"],
      );
      const [, facts, points, triangles, coordinates, isSecond] = asked[2];
      assert.deepEqual(facts, { name: other, vertices: 3, cells: 1, volume: 2 });
      assert.deepEqual(new Float64Array(points), SURFACE.points);
      assert.deepEqual(new Int32Array(triangles), SURFACE.triangles);
      assert.deepEqual(new Float64Array(coordinates), SURFACE.points);
      assert.equal(isSecond, second);
    }
    assert.equal(told?.name, "what A is compared with");
  }
});

test("S6: each is asked what it hands over by the other's fingerprint: of other cells there are no coordinates", async () => {
  const [a, b] = [side("A", { mark: "some" }), side("B", { mark: "others" })];
  await match(a.one, b.one, always);
  assert.deepEqual(a.asked[1], ["hand_over", "others"]);
  assert.deepEqual(b.asked[1], ["hand_over", "some"]);
  for (const { asked } of [a, b]) assert.equal(asked[2][4], null);
});

test("S6: what is handed over is a copy: the block that an answer lies in is not taken away", async () => {
  const [a, b] = [side("A"), side("B")];
  await match(a.one, b.one, always);
  for (const { asked, block } of [a, b]) {
    assert.equal(asked[2][2].byteLength, SURFACE.points.byteLength, "and of no more than was meant");
    assert.equal(block.length, 20, "it is there yet");
  }
  assert.equal(SURFACE.triangles.length, 3);
});

test("S6: it stops where it is wanted no more, and tells nothing then", async () => {
  const asked = async (/** @type {number} */ answers, offered = /** @type {string | null} */ (null)) => {
    const [a, b] = [side("A", { offered }), side("B", { offered })];
    let left = answers;
    assert.equal(await match(a.one, b.one, () => left-- > 0), null);
    return a.asked.map(([method]) => method);
  };
  assert.deepEqual(await asked(0), ["fingerprint"]);
  assert.deepEqual(await asked(1), ["fingerprint", "hand_over"]);
  assert.deepEqual(await asked(2), ["fingerprint", "hand_over", "compare_with"]);
  assert.deepEqual(await asked(0, "0"), ["compare_with_offered"]);
});

test("S6: a core that fails is told by its error", async () => {
  const [a, b] = [side("A"), side("B")];
  b.one.client.call = async () => {
    throw new Error("out of memory");
  };
  await assert.rejects(match(a.one, b.one, always), /out of memory/);
});
