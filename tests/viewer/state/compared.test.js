import assert from "node:assert/strict";
import { test } from "node:test";
import { tableCsv, withoutComparison } from "../../../static/viewer/state/compared.js";
import { merge } from "../../../static/viewer/state/paths.js";
import { DEFAULTS } from "../defaults.js";

const METRICS = /** @type {any[]} */ ([
  { id: "scaled_jacobian", better: "high" },
  { id: "volume", better: "high" },
  { id: "skew", better: "low" },
  { id: "oddy", better: "low" },
]);

/** @param {number | null} min @param {number | null} mean @param {number | null} max */
const statistics = (min, mean, max) => /** @type {any} */ ({ min, mean, max, median: 99 });

const A = {
  scaled_jacobian: statistics(-0.5, 0.25, 1),
  skew: statistics(0, 1, 2),
  volume: statistics(1, 1, 1),
};
const B = {
  scaled_jacobian: statistics(0.25, 0.5, 0.75),
  skew: statistics(null, 3, null),
  oddy: statistics(0, 0, 0),
};

test("S6: the table has a row for each metric that was measured of both, in the metrics' order", () => {
  const lines = tableCsv(METRICS, A, B).split("\r\n");
  assert.equal(lines[0], "metric,better,min A,min B,min B-A,mean A,mean B,mean B-A,max A,max B,max B-A");
  assert.deepEqual(
    lines.slice(1).map((line) => line.split(",")[0]),
    ["scaled_jacobian", "skew", ""],
    "volume and oddy are known of one alone; the last line is ended",
  );
});

test("S6: what the second has more is told with its sign, and nothing where a value is not finite", () => {
  const [, jacobian, skew] = tableCsv(METRICS, A, B).split("\r\n");
  assert.equal(jacobian, "scaled_jacobian,high,-0.5,0.25,0.75,0.25,0.5,0.25,1,0.75,-0.25");
  assert.equal(skew, "skew,low,0,,,1,3,2,2,,");
  const turned = tableCsv(METRICS, B, A).split("\r\n");
  assert.equal(turned[2], "skew,low,,0,,3,1,-2,,2,");
});

test("S6: every row has as many fields as the head, and without a metric there is the head alone", () => {
  for (const line of tableCsv(METRICS, A, B).split("\r\n").slice(0, -1))
    assert.equal(line.split(",").length, 11, line);
  assert.equal(tableCsv(METRICS, {}, B).split("\r\n").length, 2);
});

const TABLES = { compared: /** @type {any[]} */ ([{ id: "compare:displacement" }, { id: "change:volume" }]) };

/** A status as it is when the comparison has ended. @param {import("../../../static/viewer/state/status.js").PartialStatus} partial */
const ended = (partial) => {
  const status = merge(DEFAULTS, partial);
  return merge(status, withoutComparison(status, DEFAULTS, TABLES));
};

test("S6: a status of one mesh has no name and no cells of another, and looks at nothing of both", () => {
  const band = (/** @type {string} */ quantity) => ({
    quantity,
    keep: /** @type {const} */ ("inside"),
    minimum: 0,
    maximum: null,
  });
  const found = ended({
    colour: { by: "attribute", attribute: "change:volume", metric: "skew", map: "diverging", range: [0, 1] },
    arrows: { attribute: "compare:displacement", length: 0.2 },
    filters: { quality: { enabled: false, items: [band("change:volume"), band("skew")] } },
    compare: {
      other: { name: "b", sha256: "b", cells: 3 },
      picking: { isolated: true, shown: [1] },
      divider: 0.2,
    },
  });
  assert.deepEqual(
    found,
    merge(DEFAULTS, {
      colour: { by: "quality", metric: "skew" },
      arrows: { length: 0.2 },
      filters: { quality: { enabled: false, items: [band("skew")] } },
      compare: { divider: 0.2 },
    }),
  );
});

test("S6: a status that has nothing of a comparison stays the same one", () => {
  const heated = {
    colour: {
      by: /** @type {const} */ ("attribute"),
      attribute: "cell:heat",
      map: /** @type {const} */ ("jet"),
    },
  };
  const status = merge(DEFAULTS, heated);
  assert.equal(merge(status, withoutComparison(status, DEFAULTS, TABLES)), status);
});
