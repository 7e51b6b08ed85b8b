import { rangeOf } from "../state/choices.js";
import { count } from "../state/numbers.js";
import { pickingControls } from "./picking.js";
import { qualityFilterControls } from "./quality_filter.js";
import { sliceControls } from "./slice.js";
import { structureFilter } from "./structure_filter.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/** Whether plane and peel hide anything, so that there is something to smooth. @param {Context} context */
function hidesByShape({ store }) {
  const { planes, peel } = store.status.filters;
  const cuts = planes.enabled && planes.items.some(({ enabled, offset }) => enabled && offset > 0);
  return cuts || (peel.enabled && peel.depth > 0);
}

/** @type {import("../widgets/section.js").Section} */
export const filters = {
  id: "filters",
  title: "Filters",
  open: true,
  digestOf: { facts: ["shown", "summary"] },
  digest: ({ facts }) => {
    const hidden = (facts.get("summary")?.cells ?? 0) - (facts.get("shown")?.cells ?? 0);
    return facts.get("shown") && hidden > 0 ? `${count(hidden)} hidden` : "";
  },
  controls: [
    ...sliceControls,
    {
      kind: "slider",
      id: "peel",
      label: "Peel",
      hint: "Hides layers from the boundary inwards",
      enabled: "filters.peel.enabled",
      path: "filters.peel.depth",
      facts: ["layers"],
      range: ({ facts, store }) => [
        0,
        Math.max(facts.get("layers") ?? 10, store.status.filters.peel.depth, 1),
        1,
      ],
      digits: 0,
    },
    ...qualityFilterControls,
    { kind: "custom", render: structureFilter },
    {
      kind: "slider",
      id: "regularise",
      label: "Regularise",
      hint: "Smooths what slice and peel hide: grown and shrunk this many times",
      enabled: "filters.regularisation.enabled",
      path: "filters.regularisation.strength",
      status: ["filters.planes", "filters.peel"],
      range: rangeOf("filters.regularisation.strength", 1),
      digits: 0,
      why: (context) => (hidesByShape(context) ? "" : "neither slice nor peel hides a cell"),
    },
    ...pickingControls,
  ],
};
