import assert from "node:assert/strict";
import { test } from "node:test";
import { Facts } from "../../../static/viewer/state/facts.js";
import { followSecond } from "../../../static/viewer/state/second_facts.js";

/** Facts that count who listens to them. */
class Counting extends Facts {
  listeners = 0;
  /** @override @type {Facts["on"]} */
  on(name, listener) {
    this.listeners++;
    const stop = super.on(name, listener);
    return () => {
      this.listeners--;
      stop();
    };
  }
}

/** Facts of a first mesh that are followed, and how often that was told. @param {Partial<import("../../../static/viewer/state/facts.js").FactTable>} [before] */
function followed(before = {}) {
  const facts = new Facts(before);
  let told = 0;
  followSecond({ facts }, ["summary", "statistics"], () => told++);
  return { facts, told: () => told };
}

const summary = () => /** @type {any} */ ({ cells: 1 });

test("S6: it is told at once, and whenever a second mesh comes, changes or goes", () => {
  const { facts, told } = followed();
  assert.equal(told(), 1);
  const second = new Facts();
  facts.set({ second });
  assert.equal(told(), 2);
  second.set({ summary: summary() });
  second.set({ statistics: {} });
  assert.equal(told(), 4);
  facts.set({ second: null });
  assert.equal(told(), 5);
});

test("S6: a second mesh that is there already is followed", () => {
  const second = new Facts();
  const { told } = followed({ second });
  second.set({ summary: summary() });
  assert.equal(told(), 2);
});

test("S6: facts that were not asked for, and those of the first, tell nothing", () => {
  const second = new Facts();
  const { facts, told } = followed({ second });
  second.set({ hover: { cell: 3 }, layers: 2 });
  facts.set({ summary: summary(), statistics: {} });
  assert.equal(told(), 1);
});

test("S6: a second mesh that went, or was followed by another, is listened to no more", () => {
  const { facts, told } = followed();
  const [one, other] = [new Counting(), new Counting()];
  facts.set({ second: one });
  assert.equal(one.listeners, 2);
  facts.set({ second: other });
  assert.deepEqual([one.listeners, other.listeners], [0, 2]);
  const before = told();
  one.set({ summary: summary() });
  assert.equal(told(), before);
  facts.set({ second: null });
  assert.equal(other.listeners, 0);
  for (let round = 0; round < 5; round++) {
    facts.set({ second: one });
    assert.equal(one.listeners, 2, "none is left over from before");
    facts.set({ second: null });
  }
});
