import { optionsOf } from "../state/choices.js";
import { anotherPlane, fromView, inverted, planesOf, withPlane } from "../state/planes.js";
import { buttons } from "../widgets/controls.js";

/**
 * @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../widgets/bind.js").Control} Control
 * @typedef {import("../widgets/bind.js").Action} Action
 * @typedef {import("../state/planes.js").Plane} Plane @typedef {import("../state/vectors.js").Vector} Vector
 */

const ITEMS = "filters.planes.items";

/** What every row of the slice depends on: the planes, and which of them is at hand. */
const WATCHED = /** @type {import("../widgets/bind.js").Dependencies} */ ({
  status: [ITEMS],
  facts: ["plane"],
});

/** The plane at hand. @param {Context} context @returns {Plane} */
function planeOf(context) {
  const { planes, index } = planesOf(context);
  return planes[index] ?? { enabled: true, normal: [1, 0, 0], offset: 0 };
}

/** The partial status in which the plane at hand is another. @param {Context} context @param {Partial<Plane>} change */
function changed(context, change) {
  const { planes, index } = planesOf(context);
  const items = planes.length ? withPlane(planes, index, change) : [{ ...planeOf(context), ...change }];
  return { filters: { planes: { enabled: true, items } } };
}

/** @param {string} name @param {Vector} normal @returns {Action} */
const axisButton = (name, normal) => ({
  name: `Normal along ${name}`,
  text: name,
  press: (context) => context.store.set(changed(context, { normal })),
});

/** @param {number} axis @returns {import("../widgets/bind.js").NumberField} */
const normalField = (axis) => ({
  name: "xyz"[axis],
  read: (context) => planeOf(context).normal[axis],
  write: (value, context) => {
    const normal = /** @type {[number, number, number]} */ ([...planeOf(context).normal]);
    normal[axis] = value ?? 0;
    return normal.some((x) => x !== 0) ? changed(context, { normal }) : null;
  },
});

/** @type {Action} */
const fromViewButton = {
  name: "Set plane from view",
  text: "View",
  icon: "view",
  hint: "The cut faces you; with shift, along the nearest axis (V). From behind, the plane is inverted",
  press: (context, event) => {
    const { direction } = context.store.status.camera;
    context.store.set(changed(context, fromView(planeOf(context), direction, event.shiftKey)));
  },
};

/** @type {Action} */
const addButton = {
  name: "Add a plane",
  text: "Add",
  icon: "plus",
  press: ({ store, facts }) => {
    const { items } = store.status.filters.planes;
    store.set({ filters: { planes: { items: [...items, anotherPlane(items)] } } });
    facts.set({ plane: items.length });
  },
};

/** @type {Action} */
const removeButton = {
  name: "Remove this plane",
  icon: "minus",
  disabled: (context) => planesOf(context).planes.length < 2,
  press: (context) => {
    const { planes, index } = planesOf(context);
    context.store.set({ filters: { planes: { items: planes.filter((_, at) => at !== index) } } });
    context.facts.set({ plane: Math.max(0, index - 1) });
  },
};

/** Rows of the plane filter (SPEC F1). @type {readonly Control[]} */
export const sliceControls = [
  {
    kind: "slider",
    id: "slice",
    label: "Slice",
    hint: "Hides the cells behind a plane: 0 hides nothing, 1 everything",
    enabled: "filters.planes.enabled",
    ...WATCHED,
    range: [0, 1, 0.001],
    read: (context) => planeOf(context).offset,
    write: (offset, context) => changed(context, { offset }),
    initial: 0,
    press: ({ facts }) => facts.set({ planeShown: true }),
    release: ({ facts }) => facts.set({ planeShown: false }),
    why: (context) => (planeOf(context).enabled ? "" : "this plane is switched off"),
  },
  buttons({
    label: "Plane",
    ...WATCHED,
    items: [
      fromViewButton,
      axisButton("X", [1, 0, 0]),
      axisButton("Y", [0, 1, 0]),
      axisButton("Z", [0, 0, 1]),
      {
        name: "Invert the plane",
        icon: "invert",
        hint: "Invert the plane (F)",
        press: (context) => context.store.set(changed(context, inverted(planeOf(context)))),
      },
    ],
    more: [
      {
        kind: "choice",
        id: "plane-index",
        label: "At hand",
        ...WATCHED,
        options: (context) =>
          planesOf(context).planes.map((_, at) => ({ value: String(at), name: `Plane ${at + 1}` })),
        read: (context) => String(planesOf(context).index),
        write: (index, { facts }) => void facts.set({ plane: Number(index) }),
      },
      buttons({
        label: "",
        ...WATCHED,
        items: [
          addButton,
          removeButton,
          {
            name: "This plane on",
            text: "On",
            pressed: (context) => planeOf(context).enabled,
            press: (context) => context.store.set(changed(context, { enabled: !planeOf(context).enabled })),
          },
        ],
      }),
      { kind: "numbers", label: "Normal", ...WATCHED, items: [0, 1, 2].map(normalField) },
      {
        kind: "choice",
        id: "plane-rule",
        label: "Rule",
        path: "filters.planes.rule",
        options: optionsOf("filters.planes.rule"),
      },
    ],
  }),
];
