import {
  boundedBy,
  changedKeep,
  KEEP_NAMES,
  KEEP_NAMES_OF_ATTRIBUTES,
  keepOf,
  oneSided,
  shareOf,
  thresholdOf,
} from "../state/quality_filter.js";
import { quantityOf } from "../state/quantity.js";

/**
 * @typedef {import("../widgets/bind.js").Context} Context
 * @typedef {import("../state/quality_filter.js").Band} Band
 */

const ITEMS = "filters.quality.items";
/** @type {readonly import("../widgets/bind.js").FactName[]} */
const FACTS = ["statistics", "histogram", "summary", "keep"];

/** @param {Context} context */
const itemsOf = ({ store }) => store.status.filters.quality.items;

/** The band on what the Quality panel looks at, if there is one. @param {Context} context @returns {Band | undefined} */
export function bandOf(context) {
  const { id } = quantityOf(context);
  return itemsOf(context).find((band) => band.quantity === id);
}

/** The partial status in which the band of this quantity is another; null takes it away. @param {Context} context @param {Band | null} band */
export function withBand(context, band) {
  const { id } = quantityOf(context);
  const others = itemsOf(context).filter((one) => one.quantity !== id);
  return { filters: { quality: { enabled: true, items: band ? [...others, band] : others } } };
}

/** Which end is kept: what the band says, or what was chosen while nothing is hidden yet. @param {Context} context */
function currentKeep(context) {
  const band = bandOf(context);
  if (!band) return context.facts.get("keep") ?? "worst";
  return keepOf(band, quantityOf(context));
}

/** @param {Context} context @returns {"worst" | "best"} */
function oneEnd(context) {
  return currentKeep(context) === "best" ? "best" : "worst";
}

/** @param {Context} context */
const isTwoSided = (context) => ["band", "outside"].includes(currentKeep(context));

/** @param {"minimum" | "maximum"} end @returns {import("../widgets/bind.js").NumberField} */
const endField = (end) => ({
  name: end,
  read: (context) => bandOf(context)?.[end] ?? null,
  write: (value, context) => {
    const band =
      bandOf(context) ?? changedKeep(quantityOf(context).id, "band", undefined, quantityOf(context));
    return withBand(context, /** @type {Band} */ ({ ...band, [end]: value }));
  },
});

/** Rows of the quality filter (SPEC F3); they stand in the Filters section. @type {import("../widgets/bind.js").Control[]} */
export const qualityFilterControls = [
  {
    kind: "slider",
    id: "quality-filter",
    label: "Quality",
    hint: "Hides cells by the metric chosen below; the box takes native values",
    enabled: "filters.quality.enabled",
    status: [ITEMS, "colour"],
    facts: FACTS,
    range: [0, 1, 0.001],
    hidden: isTwoSided,
    read: (context) => shareOf(bandOf(context), oneEnd(context), quantityOf(context)),
    write: (share, context) => {
      const quantity = quantityOf(context);
      return withBand(context, oneSided(quantity.id, oneEnd(context), share, quantity));
    },
    initial: 0,
    box: {
      range: () => [-Infinity, Infinity, 0.01],
      read: (context) => {
        const quantity = quantityOf(context);
        return (
          thresholdOf(bandOf(context)) ??
          (oneEnd(context) === "worst" ? quantity.bestValue : quantity.worstValue)
        );
      },
      write: (value, context) => {
        const quantity = quantityOf(context);
        return withBand(context, boundedBy(quantity.id, oneEnd(context), value, quantity));
      },
    },
  },
  {
    kind: "numbers",
    id: "quality-band",
    label: "Quality",
    enabled: "filters.quality.enabled",
    status: [ITEMS, "colour"],
    facts: FACTS,
    hidden: (context) => !isTwoSided(context),
    items: [
      { ...endField("minimum"), optional: true, placeholder: () => "lowest" },
      { ...endField("maximum"), optional: true, placeholder: () => "highest" },
    ],
  },
  {
    kind: "choice",
    id: "quality-keep",
    label: "",
    hint: "What the quality filter shows",
    unit: (context) => quantityOf(context).unit,
    status: [ITEMS, "colour", "unit"],
    facts: FACTS,
    options: (context) => {
      const { symbol, name, attribute } = quantityOf(context);
      return Object.entries(attribute ? KEEP_NAMES_OF_ATTRIBUTES : KEEP_NAMES).map(([value, text]) => ({
        value,
        name: `${text} (${symbol || name})`,
      }));
    },
    read: currentKeep,
    write: (chosen, context) => {
      const keep = /** @type {import("../state/quality_filter.js").Keep} */ (chosen);
      context.facts.set({ keep });
      const quantity = quantityOf(context);
      const band = bandOf(context);
      if (!band && (keep === "worst" || keep === "best")) return null;
      return withBand(context, changedKeep(quantity.id, keep, band, quantity));
    },
  },
];
