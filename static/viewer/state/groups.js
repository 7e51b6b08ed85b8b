import { count } from "./numbers.js";

/**
 * The file's groups of cells and nodes, and its elements of lower dimension, as panels tell them.
 *
 * @typedef {import("./answers.js").GroupRow} GroupRow
 * @typedef {import("./answers.js").FeatureGroup} FeatureGroup
 * @typedef {import("./facts.js").Facts} Facts
 * @typedef {"corners" | "edges" | "faces"} Dimension
 */

/** What origins are called; arrays go by their own names. @type {Readonly<Record<string, string>>} */
const ORIGINS = {
  elset: "Element sets",
  nset: "Node sets",
  material: "Materials",
  instance: "Instances",
  part: "Parts",
  physical: "Physical groups",
  entity: "Entities",
  partition: "Partitions",
  reference: "References",
  attribute_set: "Sets of attributes",
  surface: "Surfaces",
  mark: "Marks",
};

/** What elements of lower dimension are called, one and several. @type {Readonly<Record<Dimension, readonly [string, string]>>} */
export const FEATURE_NAMES = {
  corners: ["corner", "corners"],
  edges: ["edge", "edges"],
  faces: ["face", "faces"],
};

/** @type {readonly Dimension[]} */
export const DIMENSIONS = ["corners", "edges", "faces"];

/** @param {string} origin */
export const originName = (origin) => ORIGINS[origin] ?? origin;

/** What a group is called on the screen: one that a number alone tells, with its array. @param {Pick<GroupRow, "name" | "origin" | "number">} group */
export function groupName({ name, origin, number }) {
  return name === String(number) ? `${origin} ${name}` : name;
}

/** The groups of cells by their origins, in order. @param {readonly GroupRow[]} groups @returns {Map<string, GroupRow[]>} */
export function byOrigin(groups) {
  /** @type {Map<string, GroupRow[]>} */
  const found = new Map();
  for (const group of groups) {
    if (group.kind !== "cells") continue;
    const some = found.get(group.origin) ?? [];
    found.set(group.origin, [...some, group]);
  }
  return found;
}

/** @type {readonly GroupRow[]} */
const NONE = Object.freeze([]);

/** The same list as long as the groups are the same. @param {Facts} facts @returns {readonly GroupRow[]} */
export const groupsOf = (facts) => facts.get("description")?.groups ?? NONE;

/** What settings name a group of features by. @param {Dimension} dimension @param {Pick<FeatureGroup, "id">} group */
export const idOfFeature = (dimension, { id }) => `${dimension}:${id}`;

/** What settings may name of a mesh: its groups of cells, nodes and features. @param {Facts} facts @returns {ReadonlySet<string>} */
export function idsOfGroups(facts) {
  const features = facts.get("description")?.features;
  return new Set([
    ...groupsOf(facts).map(({ id }) => id),
    ...DIMENSIONS.flatMap((name) =>
      (features?.[name]?.groups ?? []).map((group) => idOfFeature(name, group)),
    ),
  ]);
}

/**
 * What the colours of groups stand for, in the groups' order: of all where they are few, else of the largest.
 *
 * @param {import("./answers.js").Colour | null} drawn @param {readonly GroupRow[]} groups @param {number} most
 * @returns {{ keys: { colour: number, group: GroupRow }[], more: number }} and how many groups have none there
 */
export function groupKeys(drawn, groups, most) {
  const known = new Map(groups.map((group) => [group.id, group]));
  const keys = (drawn?.groups ?? []).flatMap(({ id, colour }) => {
    const group = known.get(id);
    return group ? [{ colour, group }] : [];
  });
  const kept = new Set([...keys].sort((a, b) => b.group.count - a.group.count).slice(0, most));
  return { keys: keys.filter((key) => kept.has(key)), more: Math.max(0, keys.length - most) };
}

/** The origin that cells are coloured by: what the status names, else the first. @param {import("./quantity.js").Known} known */
export function groupingOf({ store, facts }) {
  const origins = [...byOrigin(groupsOf(facts)).keys()];
  const { grouping } = store.status.colour;
  return origins.includes(grouping) ? grouping : (origins[0] ?? "");
}

/** "3 element sets, 12 node sets". @param {readonly GroupRow[]} groups */
export function groupsInWords(groups) {
  const cells = groups.filter(({ kind }) => kind === "cells").length;
  const nodes = groups.length - cells;
  return [cells && `${count(cells)} of cells`, nodes && `${count(nodes)} of nodes`]
    .filter(Boolean)
    .join(", ");
}
