import assert from "node:assert/strict";
import { test } from "node:test";
import { Figures } from "../../../static/viewer/app/figures.js";
import { categoryColour } from "../../../static/viewer/colours/palettes.js";
import { Facts } from "../../../static/viewer/state/facts.js";

/** What the legend of a figure tells of groups. @param {number} count @param {{ without?: number, title?: string }} [more] */
async function legend(count, { without = 0, title = "" } = {}) {
  const rows = Array.from({ length: count }, (_, k) => ({
    id: `elset:S${k}`,
    name: `S${k}`,
    origin: "elset",
    kind: "cells",
    number: null,
    count: k + 1,
  }));
  const facts = new Facts(
    /** @type {any} */ ({
      description: { groups: rows },
      colour: { label: "elset", without, groups: rows.map(({ id }, k) => ({ id, colour: k % 12 })) },
    }),
  );
  const status = {
    background: "#ffffff",
    colour: { by: "group", missing: "#8c8c8c" },
    figure: { legend_title: title, legend: "bar" },
    histogram: { bins: 10 },
  };
  return /** @type {any} */ (
    await new Figures(/** @type {any} */ ({ store: { status }, facts, client: {} })).scale()
  );
}

test("F2: the legend of a figure names the groups by their colours, and what is in none", async () => {
  const { title, colours } = await legend(2, { without: 5 });
  assert.equal(title, "Element sets");
  assert.deepEqual(colours, [
    { colour: categoryColour("group", 0), name: "S0" },
    { colour: categoryColour("group", 1), name: "S1" },
    { colour: "#8c8c8c", name: "in none" },
  ]);
  assert.equal((await legend(2, { title: "Steel and glass" })).title, "Steel and glass");
});

test("F2: of many groups it names the largest, in their order, and how many more there are", async () => {
  const { colours } = await legend(300);
  assert.deepEqual(
    colours.map((/** @type {{ name: string }} */ { name }) => name),
    [...Array.from({ length: 12 }, (_, k) => `S${288 + k}`), "and 288 more"],
  );
});
