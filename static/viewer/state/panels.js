/**
 * Several pictures under one status with one setting that changes: which, and to what.
 *
 * @typedef {import("./status.js").Status} Status
 * @typedef {import("./status.js").PartialStatus} PartialStatus
 * @typedef {import("./status.js").Choices} Choices
 * @typedef {Exclude<Status["figure"]["panels"]["setting"], "none">} Setting
 *
 * @typedef {object} Row
 * @property {readonly number[]} values that are offered
 * @property {keyof Choices} [words] setting whose words the values are places of
 * @property {(value: number, status: Status, words: readonly string[]) => PartialStatus} apply words: of the setting, where it has some
 */

/** @param {number} value */
const whole = (value) => Math.max(0, Math.round(value));

/** @param {readonly string[]} words @param {number} place */
const wordAt = (words, place) => words[Math.min(words.length - 1, whole(place))];

/** @type {{ readonly [Name in Setting]: Row }} */
export const PANELS = {
  peel: {
    values: [0, 1, 2, 3, 4],
    apply: (depth) => ({ filters: { peel: { enabled: true, depth: whole(depth) } } }),
  },
  regularisation: {
    values: [0, 1, 2, 3],
    apply: (strength) => ({
      filters: { regularisation: { enabled: true, strength: Math.min(5, whole(strength)) } },
    }),
  },
  irregular: { values: [1, 3, 5], apply: (mode) => ({ irregular: { mode: Math.min(6, whole(mode)) } }) },
  separation: {
    values: [0, 1, 2, 3],
    words: "separation.mode",
    apply: (place, _, words) => ({
      separation: { mode: /** @type {Status["separation"]["mode"]} */ (wordAt(words, place)) },
    }),
  },
  lighting: {
    values: [3, 2, 1, 0],
    words: "lighting.mode",
    apply: (place, _, words) => ({
      lighting: { mode: /** @type {Status["lighting"]["mode"]} */ (wordAt(words, place)) },
    }),
  },
  slice: {
    values: [0, 0.25, 0.5, 0.75],
    apply: (offset, { filters }) => {
      const [first, ...others] = filters.planes.items;
      const plane = first ?? { enabled: true, normal: [1, 0, 0] };
      const items = [{ ...plane, enabled: true, offset: Math.min(1, Math.max(0, offset)) }, ...others];
      return { filters: { planes: { enabled: true, items } } };
    },
  },
  silhouette: {
    values: [0, 0.5, 1],
    apply: (strength) => ({ silhouette: Math.min(1, Math.max(0, strength)) }),
  },
  line_opacity: {
    values: [0.1, 0.35, 0.7, 1],
    apply: (opacity) => ({ separation: { line_opacity: Math.min(1, Math.max(0, opacity)) } }),
  },
};

/** The partial statuses of a figure's panels; one that changes nothing where there are none. @param {Status} status @param {import("./tables.js").Tables["choices"]} choices @returns {PartialStatus[]} */
export function panelsOf(status, choices) {
  const { setting, values } = status.figure.panels;
  if (setting === "none" || values.length < 2) return [{}];
  const { apply, words } = PANELS[setting];
  return values.map((value) => apply(value, status, words ? choices[words] : []));
}
