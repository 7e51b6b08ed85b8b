import assert from "node:assert/strict";
import { test } from "node:test";
import { asFarAsKnown, withReach } from "../../../static/viewer/state/known_quantities.js";
import { merge } from "../../../static/viewer/state/paths.js";
import { DEFAULTS } from "../defaults.js";

/** @param {import("../../../static/viewer/state/status.js").PartialStatus} partial */
const status = (partial) => merge(DEFAULTS, partial);

/** A mesh that has attributes of so many components. @param {Record<string, number>} attributes @returns {import("../../../static/viewer/state/known_quantities.js").Has} */
const having = (attributes) => (id, components) =>
  id in attributes && (components === undefined || attributes[id] === components);

const nothing = having({});

/** @param {string} quantity */
const band = (quantity) => ({ quantity, keep: /** @type {const} */ ("inside"), minimum: 0, maximum: null });

test("S6: a status of which a mesh has everything is the same one", () => {
  const whole = status({
    colour: { by: "attribute", attribute: "cell:heat" },
    arrows: { attribute: "point:flow" },
    filters: { quality: { items: [band("volume"), band("cell:heat")] } },
  });
  assert.equal(asFarAsKnown(whole, having({ "cell:heat": 1, "point:flow": 3 })), whole);
  assert.equal(asFarAsKnown(DEFAULTS, nothing), DEFAULTS);
});

test("S6: colours of an attribute that a mesh has not become plain, and nothing else of them changes", () => {
  const heated = status({ colour: { by: "attribute", attribute: "cell:heat", map: "jet", range: [0, 9] } });
  const drawn = asFarAsKnown(heated, nothing);
  assert.deepEqual(drawn.colour, { ...heated.colour, by: "sides", attribute: "" });
  assert.equal(drawn.filters, heated.filters);
  assert.equal(heated.colour.attribute, "cell:heat", "the status itself keeps it");
});

test("S6: an attribute that is chosen and not coloured by takes no colours away", () => {
  const resting = status({ colour: { by: "quality", attribute: "cell:heat" } });
  assert.equal(asFarAsKnown(resting, nothing), resting);
});

test("S6: arrows stay where the mesh has vectors of that name, and numbers of that name are none", () => {
  const flowing = status({ arrows: { attribute: "point:flow", length: 0.2 } });
  assert.equal(asFarAsKnown(flowing, having({ "point:flow": 3 })), flowing);
  for (const other of [nothing, having({ "point:flow": 1 }), having({ "cell:flow": 3 })])
    assert.deepEqual(asFarAsKnown(flowing, other).arrows, { ...flowing.arrows, attribute: "" });
});

test("S6: bands of metrics stay, those of attributes where the mesh has them, in their order", () => {
  const items = ["cell:heat", "volume", "point:age", "change:volume", "scaled_jacobian"].map(band);
  const filtered = status({ filters: { quality: { enabled: false, items } } });
  const { quality } = asFarAsKnown(filtered, having({ "point:age": 1 })).filters;
  assert.deepEqual(
    quality.items.map(({ quantity }) => quantity),
    ["volume", "point:age", "scaled_jacobian"],
  );
  assert.equal(quality.enabled, false);
  assert.equal(filtered.filters.quality.items.length, 5);
});

test("S6: colours are made for a range where there is one", () => {
  const reach = /** @type {[number, number]} */ ([-1, 4]);
  const reaching = withReach(DEFAULTS, reach);
  assert.deepEqual(reaching, { ...DEFAULTS, colour: { ...DEFAULTS.colour, reach: [-1, 4] } });
  reach[0] = -9;
  assert.deepEqual(reaching.colour.reach, [-1, 4], "it is a range of its own");
  assert.equal(withReach(DEFAULTS, null), DEFAULTS);
});
