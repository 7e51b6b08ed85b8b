import assert from "node:assert/strict";
import { test } from "node:test";
import { Facts } from "../../../static/viewer/state/facts.js";
import {
  byOrigin,
  groupingOf,
  groupKeys,
  groupName,
  groupsInWords,
  groupsOf,
  idOfFeature,
  idsOfGroups,
  originName,
} from "../../../static/viewer/state/groups.js";

/** @typedef {import("../../../static/viewer/state/answers.js").GroupRow} GroupRow */

/** @param {string} id "origin:name" @param {Partial<GroupRow>} [more] @returns {GroupRow} */
const group = (id, more) => {
  const [origin, name] = id.split(":");
  return { id, origin, name, kind: "cells", number: null, count: 1, ...more };
};

const KNOWN = [
  group("material:STEEL", { count: 7 }),
  group("elset:A"),
  group("material:GLASS", { count: 9 }),
  group("nset:A", { kind: "vertices" }),
  group("reference:5", { number: 5, count: 0 }),
];

test("R12: groups of cells are listed by their origins, in the file's order", () => {
  const parted = [...byOrigin(KNOWN)].map(([origin, some]) => [origin, some.map(({ name }) => name)]);
  assert.deepEqual(parted, [["material", ["STEEL", "GLASS"]], ["elset", ["A"]], ["reference", ["5"]]]); // prettier-ignore
});

test("R12: a group that a number alone tells is named with its array", () => {
  assert.deepEqual(KNOWN.map(groupName), ["STEEL", "A", "GLASS", "A", "reference 5"]);
  assert.equal(
    groupName({ name: "5", origin: "elset", number: null }),
    "5",
    "a name that looks like a number",
  );
});

test("R12: origins have names; arrays keep their own", () => {
  assert.equal(originName("nset"), "Node sets");
  assert.equal(originName("my_array"), "my_array");
});

test("R12: the folded section tells how many groups there are", () => {
  assert.equal(groupsInWords(KNOWN), "4 of cells, 1 of nodes");
  assert.equal(groupsInWords([]), "");
  assert.equal(groupsInWords(KNOWN.slice(3, 4)), "1 of nodes");
});

test("R12: the list stays the same object while the groups are the same: rows are kept by that", () => {
  const facts = new Facts();
  assert.equal(groupsOf(facts), groupsOf(facts));
  facts.set({ description: { groups: KNOWN } });
  const before = groupsOf(facts);
  facts.set({ description: { ...facts.get("description"), components: 1 } });
  assert.equal(groupsOf(facts), before);
});

test("R12: cells are coloured by the origin that was chosen, else by the first", () => {
  const known = (/** @type {string} */ grouping, /** @type {GroupRow[]} */ groups) =>
    /** @type {any} */ ({
      store: { status: { colour: { grouping } } },
      facts: new Facts({ description: { groups } }),
    });
  assert.equal(groupingOf(known("elset", KNOWN)), "elset");
  assert.equal(groupingOf(known("physical", KNOWN)), "material", "another mesh's origin");
  assert.equal(groupingOf(known("", KNOWN.slice(3, 4))), "", "sets of nodes colour no cells");
});

test("F2: a legend names all groups in their order, or the largest of many and how many more there are", () => {
  const drawn = /** @type {any} */ ({
    groups: [
      { id: "material:STEEL", colour: 3 },
      { id: "material:GONE", colour: 1 },
      { id: "elset:A", colour: 2 },
      { id: "material:GLASS", colour: 0 },
    ],
  });
  const told = (/** @type {ReturnType<typeof groupKeys>} */ { keys, more }) => [
    keys.map(({ colour, group: { name } }) => [name, colour]),
    more,
  ];
  assert.deepEqual(told(groupKeys(drawn, KNOWN, 3)), [[["STEEL", 3], ["A", 2], ["GLASS", 0]], 0]); // prettier-ignore
  assert.deepEqual(told(groupKeys(drawn, KNOWN, 2)), [[["STEEL", 3], ["GLASS", 0]], 1]); // prettier-ignore
  assert.deepEqual(told(groupKeys(null, KNOWN, 2)), [[], 0]);
});

test("S6: what settings may name of a mesh are its groups, and its features behind what they are of", () => {
  assert.equal(idsOfGroups(new Facts()).size, 0);
  const features = { edges: { groups: [group("reference:5")] }, faces: { groups: [group("reference:5")] } };
  const facts = new Facts({ description: /** @type {any} */ ({ groups: KNOWN, features }) });
  assert.deepEqual(
    [...idsOfGroups(facts)],
    [...KNOWN.map(({ id }) => id), "edges:reference:5", "faces:reference:5"],
  );
  assert.equal(idOfFeature("corners", group("mark:x")), "corners:mark:x");
});
