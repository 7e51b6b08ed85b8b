import { dot, nearestAxis, normalised, scaled } from "./vectors.js";

/**
 * What can be done to the list of cutting planes (SPEC F1). Each function makes a new list or plane.
 *
 * @typedef {import("./vectors.js").Vector} Vector
 * @typedef {import("./status.js").Status["filters"]["planes"]["items"][number]} Plane
 */

/** Within 20 degrees of opposite, setting the plane from the view inverts it. */
const OPPOSITE = -Math.cos((20 * Math.PI) / 180);

/** @param {Plane} plane @returns {Plane} */
export function inverted(plane) {
  const offset = Math.round((1 - plane.offset) * 1e12) / 1e12;
  const [x, y, z] = scaled(plane.normal, -1);
  return { ...plane, normal: [x || 0, y || 0, z || 0], offset }; // never -0
}

/**
 * The plane that faces the viewer: its normal is the view direction, so that near cells go first.
 *
 * @param {Plane} plane @param {Vector} direction view direction @param {boolean} snap to the nearest signed axis
 * @returns {Plane}
 */
export function fromView(plane, direction, snap) {
  const view = normalised(direction);
  if (dot(view, normalised(plane.normal)) < OPPOSITE) return { ...inverted(plane), enabled: true };
  return { ...plane, enabled: true, normal: snap ? nearestAxis(view) : view };
}

/**
 * The planes, and the number of the one at hand.
 *
 * @param {{ store: import("./store.js").StatusStore, facts: import("./facts.js").Facts }} known
 */
export function planesOf({ store, facts }) {
  const planes = store.status.filters.planes.items;
  return { planes, index: Math.min(facts.get("plane"), Math.max(0, planes.length - 1)) };
}

/** @param {readonly Plane[]} planes @param {number} index @param {Partial<Plane>} change @returns {Plane[]} */
export function withPlane(planes, index, change) {
  return planes.map((plane, at) => (at === index ? { ...plane, ...change } : plane));
}

/** A new plane along the axis that the planes so far use least. @param {readonly Plane[]} planes @returns {Plane} */
export function anotherPlane(planes) {
  /** @type {Vector[]} */
  const axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]; // prettier-ignore
  const use = axes.map((axis) =>
    planes.reduce((total, plane) => total + Math.abs(dot(axis, normalised(plane.normal))), 0),
  );
  return { enabled: true, normal: axes[use.indexOf(Math.min(...use))], offset: 0 };
}
