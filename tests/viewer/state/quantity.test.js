import assert from "node:assert/strict";
import { test } from "node:test";
import { Facts } from "../../../static/viewer/state/facts.js";
import { chooseQuantity, quantityOf, quantityOptions } from "../../../static/viewer/state/quantity.js";
import { StatusStore } from "../../../static/viewer/state/store.js";
import { DEFAULTS } from "../defaults.js";

const tables = /** @type {import("../../../static/viewer/state/tables.js").Tables} */ (
  /** @type {unknown} */ ({
    metrics: [
      {
        id: "scaled_jacobian",
        name: "Scaled Jacobian",
        symbol: "SJ",
        variant: "",
        better: "high",
        length_power: 0,
      },
      { id: "volume", name: "Volume", symbol: "V", variant: "", better: "high", length_power: 3 },
    ],
    traced: [{ id: "structure:blocks", name: "Block" }],
    compared: [
      {
        id: "compare:distance",
        name: "Distance",
        better: "low",
        length_power: 1,
        metric: "",
        cellwise: false,
      },
      {
        id: "compare:displacement",
        name: "Displacement",
        better: "low",
        length_power: 1,
        metric: "",
        cellwise: true,
      },
      {
        id: "change:volume",
        name: "Change of Volume",
        better: "high",
        length_power: 3,
        metric: "volume",
        cellwise: true,
      },
    ],
  })
);

const ATTRIBUTES = [
  { id: "cell:heat", name: "heat", on: "cell", components: 1, min: 0, max: 1 },
  { id: "point:flow", name: "flow, magnitude", on: "point", components: 3, min: 0, max: 1 },
];

/** @param {object} colour @param {object} [known] */
function parts(colour, known = {}) {
  const store = new StatusStore(DEFAULTS);
  store.set({ unit: "mm", colour });
  const facts = new Facts(/** @type {any} */ ({ summary: { attributes: ATTRIBUTES }, ...known }));
  return { store, facts, tables };
}

/** Colours after some quantities were chosen in turn. @param {object} colour @param {...string} ids */
function chosen(colour, ...ids) {
  const known = parts(colour);
  for (const id of ids) known.store.set(chooseQuantity(id, known));
  return known.store.status.colour;
}

test("S6: a change comes with the map whose middle is no change, and the map goes with it again", () => {
  const changed = chosen({ map: "viridis" }, "change:volume");
  assert.deepEqual([changed.by, changed.attribute, changed.map], ["attribute", "change:volume", "diverging"]);
  const back = chosen({ map: "viridis" }, "change:volume", "volume");
  assert.deepEqual([back.by, back.metric, back.map], ["quality", "volume", DEFAULTS.colour.map]);
  assert.equal(chosen({}, "change:volume", "cell:heat").map, DEFAULTS.colour.map);
});

test("S6: what has no sign keeps the map that is there, and a change the one that another change came with", () => {
  assert.equal(chosen({ map: "viridis" }, "compare:distance").map, "viridis");
  assert.equal(chosen({ map: "jet" }, "volume").map, "jet");
  assert.equal(chosen({ map: "jet" }, "cell:heat").map, "jet");
  assert.equal(chosen({ map: "diverging" }, "change:volume").map, "diverging");
});

test("S6: a map that was chosen by hand for a change is the reader's own, and stays", () => {
  const known = parts({}, {});
  known.store.set(chooseQuantity("change:volume", known));
  known.store.set({ colour: { map: "red_blue" } });
  known.store.set(chooseQuantity("volume", known));
  assert.equal(known.store.status.colour.map, "red_blue");
});

test("a metric that is chosen is looked at though colours are of something else, and an old range goes", () => {
  assert.deepEqual(
    [chosen({ by: "kind" }, "volume").by, chosen({ by: "kind" }, "volume").metric],
    ["kind", "volume"],
  );
  assert.equal(chosen({ by: "attribute", attribute: "cell:heat" }, "volume").by, "quality");
  assert.equal(chosen({ range: [0, 1] }, "volume").range, null);
  assert.equal(chosen({ range: [0, 1] }, "cell:heat").range, null);
});

/** @param {object | null} comparison */
const offered = (comparison) =>
  quantityOptions(parts({}, { comparison })).map(({ value, group }) => [value, group]);

const ALWAYS = [
  ["scaled_jacobian", "Quality"],
  ["volume", "Quality"],
  ["cell:heat", "Of cells"],
  ["point:flow", "Of points"],
  ["structure:blocks", "Structure"],
];

test("S6: quantities of a comparison are offered as long as there is one, those of single cells if the cells are the same", () => {
  assert.deepEqual(offered(null), ALWAYS);
  assert.deepEqual(offered({ same_cells: false }), [...ALWAYS, ["compare:distance", "Comparison"]]);
  assert.deepEqual(offered({ same_cells: true }), [
    ...ALWAYS,
    ...tables.compared.map(({ id }) => [id, "Comparison"]),
  ]);
});

test("S6: a quantity of a comparison has its name, its unit and its better end", () => {
  const statistics = { min: -2, max: 5, percentiles: {} };
  const colour = { by: "attribute", attribute: "change:volume" };
  const change = quantityOf(parts(colour, { statistics: { "change:volume": statistics } }));
  assert.equal(change.name, "Change of Volume");
  assert.equal(change.unit, "mm³");
  assert.deepEqual([change.worstValue, change.bestValue], [-2, 5]);
  assert.equal(change.attribute, true);
  const distance = quantityOf(
    parts(
      { by: "attribute", attribute: "compare:distance" },
      { statistics: { "compare:distance": statistics } },
    ),
  );
  assert.deepEqual([distance.worstValue, distance.bestValue, distance.unit], [5, -2, "mm"]);
});
