import { merge } from "./paths.js";

/**
 * What a mesh opens under: its own view, or what was set by hand for the one before. Everything in a status is relative to
 * the mesh, so that a view can be kept.
 *
 * @typedef {import("./status.js").Status} Status
 * @typedef {import("./status.js").PartialStatus} PartialStatus
 * @typedef {import("./answers.js").View} View
 * @typedef {"changed" | "always" | "never"} Keeping  whether another mesh keeps the view: once it was changed by hand, or
 *
 * @typedef {object} Before  what was there when a mesh is opened
 * @property {Status} status
 * @property {ReadonlySet<string>} touched sections that were changed since the program began, or was reset
 * @property {Keeping} keeping
 * @property {boolean} alike whether the meshes have as many cells, so that picked ones may mean the same
 * @property {boolean} renewed whether it is the same mesh, written anew: then all stays that can
 * @property {boolean} same whether it is the file that was open, as far as one can tell: then its unit is still true
 * @property {(quantity: string, components?: number) => boolean} has whether the mesh that is opened has this attribute, of so many
 *   components
 */

/** Sections that are where one looks, and what one sees of the mesh: they are kept together. */
const VIEW = /** @type {const} */ (["camera", "filters"]);

/**
 * The view that a mesh has of its own: three quarters from above, nothing hidden, the first slice facing the eye; over that
 * its portrait's, if it is one of the catalogue's.
 *
 * @param {Status} defaults @param {View} view @param {PartialStatus} [portrait]
 * @returns {Status}
 */
export function ownView(defaults, { direction, up, facing }, portrait = {}) {
  const own = {
    camera: { fit: true, direction, up },
    filters: { planes: { items: [{ enabled: true, normal: facing, offset: 0 }] } },
  };
  return portraitView(merge(defaults, own), portrait);
}

/**
 * What a portrait shows. A band of which it leaves out an end is open there.
 *
 * @param {Status} defaults @param {PartialStatus} [portrait] @returns {Status}
 */
export function portraitView(defaults, portrait = {}) {
  const status = merge(defaults, portrait);
  const items = status.filters.quality.items.map(({ minimum, maximum, ...band }) => ({
    ...band,
    minimum: minimum ?? null,
    maximum: maximum ?? null,
  }));
  return merge(status, { filters: { quality: { items } } });
}

/**
 * The settings that a mesh opens under, and whether the view is one that was kept.
 *
 * @param {Status} own the mesh's own @param {Before} before
 * @returns {{ settings: PartialStatus, kept: boolean }}
 */
export function openingSettings(own, { status, touched, keeping, alike, renewed, same, has }) {
  const changed = VIEW.some((section) => touched.has(section));
  const kept = renewed || keeping === "always" || (keeping === "changed" && changed);
  const { version: _, mesh: __, ...sections } = own;
  const settings = /** @type {Omit<Status, "version" | "mesh">} */ (
    Object.fromEntries(
      Object.entries(sections).map(([name, value]) => {
        const stays = VIEW.some((section) => section === name) ? kept : renewed || touched.has(name);
        return [name, stays ? status[/** @type {keyof Status} */ (name)] : value];
      }),
    )
  );
  const { colour, filters, arrows, marks } = settings;
  const known = colour.by !== "attribute" || has(colour.attribute);
  const { picking, parts, groups, quality } = filters;
  return {
    settings: {
      ...settings,
      unit: same ? status.unit : own.unit,
      colour: {
        ...colour,
        range: renewed && known ? colour.range : null,
        grouping: renewed ? colour.grouping : "",
        ...(known ? {} : { by: "sides", attribute: "" }),
      },
      arrows: arrows.attribute === "" || has(arrows.attribute, 3) ? arrows : { ...arrows, attribute: "" },
      marks: renewed ? marks : { ...marks, hidden: [], nodes: [], interfaces: "" },
      filters: {
        ...filters,
        picking: alike ? picking : own.filters.picking,
        parts: alike ? parts : own.filters.parts,
        groups: renewed ? groups : own.filters.groups,
        quality: {
          ...quality,
          items: quality.items.filter(({ quantity }) => !quantity.includes(":") || has(quantity)),
        },
      },
    },
    kept,
  };
}

/**
 * Whether a mesh has an attribute, of so many components where that matters.
 *
 * @param {import("./facts.js").MeshSummary} summary @param {string} quantity @param {number} [components]
 */
export function hasAttribute({ attributes = [] }, quantity, components = 0) {
  return attributes.some((one) => one.id === quantity && (!components || one.components === components));
}
