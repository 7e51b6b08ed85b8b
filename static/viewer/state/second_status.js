import { cameraIn } from "./frames.js";
import { asFarAsKnown, withReach } from "./known_quantities.js";

/**
 * What a second mesh makes of the one status: all settings are those of the first, but what it has not got, and what counts
 * cells, groups and parts where its cells are others.
 *
 * @typedef {import("./status.js").Status} Status
 * @typedef {import("./status.js").PartialStatus} PartialStatus
 * @typedef {import("./frames.js").Frame} Frame
 *
 * @typedef {object} Second  what is known of it
 * @property {boolean} same whether its cells are those of the first, so that numbers mean the same
 * @property {number} cells
 * @property {(quantity: string, components?: number) => boolean} has an attribute, of so many components where that matters
 * @property {(group: string) => boolean} groups whether it has one of that id, of cells, nodes or features
 * @property {{ first: Frame, second: Frame } | null} frames where both are seen at the same place; null where each is in its own
 * @property {readonly [number, number] | null} reach smallest and largest value of both, where colours are common to them
 */

/** What counts the first mesh's things. @type {number[]} */
const NONE = [];

/** @param {Status} status of the first @param {Second} second @returns {Status} */
export function secondStatus(status, { same, cells, has, groups, frames, reach }) {
  const { compare, filters, marks, structure, camera } = status;
  const below = (/** @type {readonly number[]} */ list) => list.filter((cell) => cell < cells);
  const { isolated, hidden, shown } = compare.picking;
  const ownGroups = filters.groups.shown.filter(groups);
  const own = {
    ...status,
    mesh: compare.other,
    camera: frames ? cameraIn(camera, frames.first, frames.second) : camera,
    marks: same
      ? marks
      : {
          ...marks,
          hidden: marks.hidden.filter(groups),
          nodes: marks.nodes.filter(groups),
          interfaces: "",
        },
    structure: same ? structure : { ...structure, chosen: NONE },
    filters: {
      ...filters,
      picking: same
        ? filters.picking
        : { enabled: filters.picking.enabled, isolated, hidden: below(hidden), shown: below(shown) },
      parts: same ? filters.parts : { ...filters.parts, isolated: false, hidden: NONE, shown: NONE },
      groups: {
        ...filters.groups,
        hidden: filters.groups.hidden.filter(groups),
        shown: ownGroups,
        isolated: filters.groups.isolated && ownGroups.length > 0,
      },
      structure: same
        ? filters.structure
        : { ...filters.structure, blocks: NONE, sheets: NONE, chords: NONE },
    },
  };
  return withReach(asFarAsKnown(own, has), reach);
}

/**
 * Settings that were changed at the second mesh, as they are in the status.
 *
 * @param {PartialStatus} partial @param {Pick<Second, "same" | "frames">} second @returns {PartialStatus}
 */
export function fromSecond(partial, { same, frames }) {
  const { mesh, camera, filters, ...others } = partial;
  const { picking, ...rest } = filters ?? {};
  const { enabled, ...picked } = picking ?? {};
  const compare = {
    ...others.compare,
    ...(mesh ? { other: mesh } : {}),
    ...(same || !Object.keys(picked).length ? {} : { picking: picked }),
  };
  const shared = enabled === undefined ? rest : { ...rest, picking: { enabled } };
  return {
    ...others,
    ...(camera ? { camera: frames ? cameraIn(camera, frames.second, frames.first) : camera } : {}),
    ...(filters ? { filters: same ? filters : shared } : {}),
    ...(Object.keys(compare).length ? { compare } : {}),
  };
}
