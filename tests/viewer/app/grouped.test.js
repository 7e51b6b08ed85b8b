import assert from "node:assert/strict";
import { test } from "node:test";
import { Grouped } from "../../../static/viewer/app/grouped.js";
import { Messages } from "../../../static/viewer/app/messages.js";
import { Superseded } from "../../../static/viewer/core/client.js";
import { Facts } from "../../../static/viewer/state/facts.js";

const ROW = { id: "elset:A", volume: 2, scaled_jacobian_min: 0.5, scaled_jacobian_mean: 0.75, invalid: 0 };

/** A core that answers when told. */
function parts() {
  const facts = new Facts({ core: "ready", summary: /** @type {any} */ ({ name: "first" }) });
  /** @type {{ method: string, args: any[], options: any, answer: (value: any) => void, fail: (error: Error) => void }[]} */
  const calls = [];
  const client = {
    call: (/** @type {string} */ method, /** @type {any[]} */ args, /** @type {any} */ options) =>
      new Promise((answer, fail) => calls.push({ method, args, options, answer, fail })),
  };
  const app = /** @type {any} */ ({ facts, client, messages: new Messages(facts) });
  return { grouped: new Grouped(app), facts, calls };
}

test("R12: groups are measured once, however often the panel asks meanwhile", async () => {
  const { grouped, facts, calls } = parts();
  const first = grouped.measure();
  await grouped.measure();
  assert.equal(calls.length, 1);
  calls[0].answer([ROW]);
  await first;
  assert.deepEqual(facts.get("groupMeasures"), { "elset:A": ROW });
});

test("R12: interfaces are kept with their origin; one of another replaces the question", async () => {
  const { grouped, facts, calls } = parts();
  const both = [grouped.meet("elset"), grouped.meet("material")];
  assert.deepEqual(
    calls.map(({ args, options }) => [args, options]),
    [
      [["elset"], { replace: "interfaces" }],
      [["material"], { replace: "interfaces" }],
    ],
  );
  calls[0].fail(new Superseded());
  calls[1].answer([]);
  await Promise.all(both);
  assert.deepEqual(facts.get("interfaces"), { origin: "material", rows: [] });
  assert.deepEqual(facts.get("messages"), []);
});

test("R12: an answer of the mesh before is dropped, and that of the next is asked for", async () => {
  const { grouped, facts, calls } = parts();
  const old = grouped.measure();
  facts.set({ summary: /** @type {any} */ ({ name: "second" }) });
  const next = grouped.measure();
  assert.equal(calls.length, 2);
  calls[0].answer([ROW]);
  await old;
  assert.equal(facts.get("groupMeasures"), null);
  calls[1].answer([{ ...ROW, volume: 9 }]);
  await next;
  assert.equal(facts.get("groupMeasures")?.["elset:A"].volume, 9);
});

test("R12: what failed is a message, and can be asked for again", async () => {
  const { grouped, facts, calls } = parts();
  const first = grouped.measure();
  calls[0].fail(new Error("out of memory"));
  await first;
  assert.equal(facts.get("messages")[0].text, "out of memory");
  void grouped.measure();
  assert.equal(calls.length, 2);
});

test("R12: nothing is asked while the core starts", async () => {
  const { grouped, facts, calls } = parts();
  facts.set({ core: "starting" });
  await grouped.measure();
  assert.equal(calls.length, 0);
});
