import assert from "node:assert/strict";
import { test } from "node:test";

import { openingSettings, ownView } from "../../../static/viewer/state/opening_view.js";

const defaults = /** @type {import("../../../static/viewer/state/status.js").Status} */ (
  /** @type {unknown} */ ({
    version: 2,
    mesh: { name: "", sha256: "", cells: 0 },
    unit: "none",
    camera: { fit: true, target: [0, 0, 0], direction: [0, 0, -1], up: [0, 1, 0], distance: 1.5 },
    filters: {
      planes: { enabled: true, items: [{ enabled: true, normal: [1, 0, 0], offset: 0 }] },
      quality: { enabled: true, items: [] },
      parts: { enabled: true, isolated: false, hidden: [], shown: [] },
      groups: { enabled: true, isolated: false, hidden: [], shown: [] },
      picking: { enabled: true, isolated: false, hidden: [], shown: [] },
    },
    separation: { mode: "lines" },
    colour: { by: "sides", attribute: "", metric: "scaled_jacobian", grouping: "", range: null },
    arrows: { attribute: "", length: 0.05, colour: "#1d1f23" },
    marks: { edges: true, hidden: [], sharp_angle: 180, nodes: [], interfaces: "" },
  })
);
const view = /** @type {import("../../../static/viewer/state/opening_view.js").View} */ ({
  direction: [-0.5, 0.8, -0.4],
  up: [0, 0, 1],
  facing: [0, 1, 0],
});
const own = ownView(defaults, view);
const untouched = {
  status: defaults,
  touched: /** @type {Set<string>} */ (new Set()),
  keeping: /** @type {const} */ ("changed"),
  alike: false,
  renewed: false,
  same: false,
  has: () => false,
};
const turned = {
  ...defaults,
  camera: { ...defaults.camera, fit: false, direction: /** @type {const} */ ([1, 0, 0]) },
  filters: {
    ...defaults.filters,
    quality: {
      enabled: true,
      items: [
        { quantity: "scaled_jacobian", keep: /** @type {const} */ ("inside"), minimum: 0, maximum: 1 },
        { quantity: "cell:heat", keep: /** @type {const} */ ("inside"), minimum: 0, maximum: 1 },
      ],
    },
    picking: { enabled: true, isolated: false, hidden: [3], shown: [] },
  },
};

test("V6: a mesh opens whole, in its own view, with a slice that faces the eye", () => {
  const { settings, kept } = openingSettings(own, untouched);
  assert.equal(kept, false);
  assert.deepEqual(settings.camera, { ...defaults.camera, direction: view.direction, up: view.up });
  assert.deepEqual(settings.filters?.planes?.items, [{ enabled: true, normal: view.facing, offset: 0 }]);
});

test("C4: an end that a portrait's band leaves out is open", () => {
  const band = { quantity: "scaled_jacobian", keep: "inside", maximum: 0.3 };
  const portrait = /** @type {any} */ ({ filters: { quality: { items: [band] } } });
  const { items } = ownView(defaults, view, portrait).filters.quality;
  assert.deepEqual(items, [{ ...band, minimum: null }]);
});

test("C4: one of the catalogue opens as its portrait shows it", () => {
  const portrait = { separation: { mode: /** @type {const} */ ("rounded") } };
  const { settings } = openingSettings(ownView(defaults, view, portrait), untouched);
  assert.equal(settings.separation?.mode, "rounded");
});

test("S1: what was changed by hand is kept: camera and filters together, every other section by itself", () => {
  const kept = openingSettings(own, { ...untouched, status: turned, touched: new Set(["camera"]) });
  assert.equal(kept.kept, true);
  assert.deepEqual(kept.settings.camera, turned.camera);
  assert.deepEqual(
    kept.settings.filters?.quality?.items?.map(({ quantity }) => quantity),
    ["scaled_jacobian"],
    "the mesh has no attribute heat",
  );
  assert.deepEqual(kept.settings.filters?.picking?.hidden, [], "another number of cells");
  const coloured = { ...defaults, colour: { ...defaults.colour, by: /** @type {const} */ ("quality") } };
  const other = openingSettings(own, { ...untouched, status: coloured, touched: new Set(["colour"]) });
  assert.equal(other.kept, false);
  assert.equal(other.settings.colour?.by, "quality");
  assert.deepEqual(other.settings.camera?.direction, view.direction);
});

test("S1: picked cells stay where the meshes have as many cells", () => {
  const { settings } = openingSettings(own, {
    ...untouched,
    status: turned,
    touched: new Set(["filters"]),
    alike: true,
  });
  assert.deepEqual(settings.filters?.picking?.hidden, [3]);
});

test("S1: the view can be kept always, or never", () => {
  const touched = new Set(["camera"]);
  assert.equal(openingSettings(own, { ...untouched, status: turned, keeping: "always" }).kept, true);
  assert.equal(openingSettings(own, { ...untouched, status: turned, touched, keeping: "never" }).kept, false);
});

test("S1: an attribute that the next mesh lacks colours nothing", () => {
  const status = {
    ...defaults,
    colour: { ...defaults.colour, by: /** @type {const} */ ("attribute"), attribute: "cell:heat" },
  };
  const touched = new Set(["colour"]);
  assert.equal(openingSettings(own, { ...untouched, status, touched }).settings.colour?.by, "sides");
  assert.equal(
    openingSettings(own, { ...untouched, status, touched, has: () => true }).settings.colour?.by,
    "attribute",
  );
});

test("S1: arrows stay where the next mesh has vectors of that name, and only the choice goes where it has not", () => {
  const status = { ...defaults, arrows: { ...defaults.arrows, attribute: "point:flow", length: 0.2 } };
  const touched = new Set(["arrows"]);
  /** @param {Record<string, number>} attributes numbers of components */
  const opened = (attributes) =>
    openingSettings(own, {
      ...untouched,
      status,
      touched,
      has: (id, components = 0) => id in attributes && (!components || attributes[id] === components),
    }).settings.arrows;
  assert.deepEqual(opened({ "point:flow": 3 }), status.arrows);
  /** @type {Record<string, number>[]} */
  const without = [{}, { "point:flow": 1 }, { "cell:flow": 3 }];
  for (const others of without)
    assert.deepEqual(opened(others), { ...status.arrows, attribute: "" }, JSON.stringify(others));
  const kept = openingSettings(own, { ...untouched, status, has: () => true }).settings.arrows;
  assert.equal(kept?.attribute, "", "nobody chose them for this mesh");
});

test("A5: a mesh that was written anew keeps all that it can", () => {
  const { version: _, mesh: __, ...sections } = turned;
  const status = {
    ...turned,
    colour: { ...turned.colour, by: /** @type {const} */ ("quality"), range: [0.2, 1] },
  };
  const renewed = {
    ...untouched,
    status: /** @type {any} */ (status),
    renewed: true,
    same: true,
    alike: true,
  };
  const { settings } = openingSettings(own, renewed);
  const filters = {
    ...sections.filters,
    quality: { enabled: true, items: sections.filters.quality.items.slice(0, 1) },
  };
  assert.deepEqual(settings, { ...sections, colour: status.colour, filters });
  const other = openingSettings(own, { ...renewed, alike: false, has: () => true }).settings;
  assert.deepEqual(other.filters?.picking, own.filters.picking, "of other cells none is picked");
  assert.equal(other.filters?.quality?.items?.length, 2);
});

test("R12: groups belong to their file: another mesh shows all of its own, and draws none of the last one's", () => {
  const status = {
    ...defaults,
    colour: { ...defaults.colour, grouping: "elset" },
    filters: {
      ...defaults.filters,
      groups: { enabled: true, isolated: false, hidden: ["elset:A"], shown: [] },
    },
    marks: {
      ...defaults.marks,
      hidden: ["edges:reference:1"],
      nodes: ["nset:N"],
      interfaces: "elset",
      sharp_angle: 40,
    },
  };
  const before = { ...untouched, status, touched: new Set(["marks", "colour", "camera"]) };
  const other = openingSettings(own, before).settings;
  assert.deepEqual(other.filters?.groups?.hidden, []);
  assert.equal(other.colour?.grouping, "");
  assert.deepEqual(
    other.marks,
    { ...defaults.marks, sharp_angle: 40 },
    "what means the same of any mesh stays",
  );
  const same = openingSettings(own, { ...before, renewed: true, same: true, alike: true }).settings;
  assert.deepEqual(same.marks, status.marks);
  assert.deepEqual(same.filters?.groups, status.filters.groups);
});

test("S1: a unit that was named is one file's: it stays with this, and no other mesh takes it over", () => {
  const status = { ...defaults, unit: /** @type {const} */ ("mm") };
  const before = { ...untouched, status, touched: new Set(["unit", "camera"]), alike: true };
  for (const keeping of /** @type {const} */ (["changed", "always", "never"]))
    assert.equal(openingSettings(own, { ...before, keeping }).settings.unit, "none");
  assert.equal(openingSettings(own, { ...before, same: true }).settings.unit, "mm");
  const portrait = ownView(defaults, view, { unit: "in" });
  assert.equal(
    openingSettings(portrait, before).settings.unit,
    "in",
    "one of the catalogue may name its own",
  );
});
