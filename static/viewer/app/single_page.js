import { compactIrregular } from "../exchange/compact_irregular.js";
import { compact } from "../exchange/compact_surface.js";
import { toPlanes } from "../exchange/planes.js";
import { PLACE } from "../exchange/sheet.js";
import { steps, summed } from "../exchange/steps.js";
import { legendAlone, textOf } from "../figure/compose.js";
import { FAMILY, INK } from "../figure/legend.js";
import { toBase64 } from "../files/base64.js";
import { gzipped } from "../files/gzip.js";
import { pack } from "../files/packing.js";
import { inOneLine } from "../state/entry.js";
import { MOST_METRICS, MOST_SLICES } from "../state/leaving.js";
import { PANELS } from "../state/panels.js";
import { chooseQuantity, quantityOptions } from "../state/quantity.js";
import { metricOf } from "../state/tables.js";
import { unitOf } from "../state/units.js";
import { posed } from "./posing.js";

/**
 * @typedef {import("../exchange/sheet.js").Sheet} Sheet
 * @typedef {import("../exchange/compact_surface.js").Compact} Compact
 * @typedef {import("../state/leaving.js").PageWanted} Wanted
 */

/** The legend in pixels: its width, its height with a histogram, a row of a list; pixels to a point, letters in points; bars. */
const LEGEND = { width: 200, height: 280, row: 19 };
const STYLE = { point: 96 / 72, size: 8.5, ink: INK, family: FAMILY, counts: true };
const BARS = 40;

/** Longer side of the picture that stands until the mesh is drawn, in pixels, and how much of it is kept. */
const POSTER = 800;
const QUALITY = 0.7;

/** The mesh in a page of one file that opens from a disk (SPEC A7): surfaces, colours, light, and a camera to turn. */
export class SinglePage {
  #app;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /** @param {Wanted} [wanted] @returns {Promise<Blob>} */
  async file(wanted = {}) {
    const { facts, host } = this.#app;
    const { metrics = [], slices = [] } = this.#checked(wanted);
    if (!facts.get("shown")?.cells) throw new Error("no cell is shown: there is nothing to save");
    const shell = await host.sheet();
    const poster = await this.#poster();
    const shots = await this.#shots(slices);
    const { cells, numbers } = renumbered(shots);
    const colours = await this.#colours(metrics, numbers);
    const about = await this.#about(wanted);
    /** @type {Sheet} */
    const sheet = { ...this.#scene(), shots: cells, colours, numbers: steps(this.#told(numbers)), about };
    return filled(
      shell,
      about,
      poster,
      toBase64(await gzipped(pack(/** @type {object} */ (toPlanes(sheet))))),
    );
  }

  /** @param {Wanted} wanted @returns {Wanted} */
  #checked({ metrics = [], slices = [], ...others }) {
    const known = quantityOptions(this.#app).map(({ value }) => value);
    for (const id of metrics)
      if (!known.includes(id))
        throw new Error(`found the metric ‘${id}’, expected one of ${known.join(", ")}`);
    for (const offset of slices)
      if (!(offset >= 0 && offset <= 1))
        throw new Error(`found the slice ${offset}, expected numbers from 0 to 1`);
    if (slices.length > MOST_SLICES)
      throw new Error(`found ${slices.length} slices, expected at most ${MOST_SLICES}`);
    if (metrics.length > MOST_METRICS)
      throw new Error(`found ${metrics.length} metrics, expected at most ${MOST_METRICS}`);
    return { metrics, slices, ...others };
  }

  /** The file's numbers of cells, or their rows where numbers are longer than a page of one file can hold. @param {Uint32Array} rows */
  #told(rows) {
    const numbering = this.#app.facts.get("numbering");
    const numbers = Array.from(rows, (row) => numbering.of(row));
    return numbers.every((number) => number >= 0 && number < 2 ** 31) ? Uint32Array.from(numbers) : rows;
  }

  /** What is drawn besides surfaces and their colours, and how. */
  #scene() {
    const { store, facts, drawing, leaving } = this.#app;
    const { status } = store;
    const { camera, colour, separation, silhouette, see_through, arrows, irregular, structure, background } =
      status;
    const { centre, diagonal, frame, cells, outline } =
      /** @type {import("../state/facts.js").MeshSummary} */ (facts.get("summary"));
    const mode = leaving.lit ? /** @type {const} */ ("object_space_ao") : status.lighting.mode;
    const lighting = { ...status.lighting, mode };
    return {
      status: {
        camera,
        colour,
        separation,
        silhouette,
        see_through,
        arrows,
        irregular,
        structure,
        lighting,
        background,
      },
      mesh: { centre, diagonal, frame, cells, outline },
      irregular: irregular.mode > 0 ? compactIrregular(drawing.records.irregular, irregular.boundary) : null,
    };
  }

  /** What each slice shows. @param {readonly number[]} slices @returns {Promise<Sheet["shots"]>} */
  #shots(slices) {
    const { store, facts, drawing, scene, leaving } = this.#app;
    const { status } = store;
    const poses = slices.length ? slices.map((offset) => PANELS.slice.apply(offset, status, [])) : [{}];
    return posed(this.#app, poses, async (k) => {
      await scene.settled();
      const light = leaving.lit ? await scene.lighting.baked() : new Float32Array(0);
      const { surface, silhouette, see_through, arrows, marks, curves } = drawing.records;
      if (!surface) throw new Error("there is no picture to save");
      return {
        slice: slices[k] ?? null,
        cells: facts.get("shown")?.cells ?? 0,
        surface: compact(surface),
        openness: Uint8Array.from(light, (part) => Math.round(255 * part)),
        silhouette: status.silhouette > 0 && silhouette ? compact(plainQuads(silhouette)) : null,
        see_through: see_through ? compact(see_through) : null,
        arrows: status.arrows.attribute !== "" && arrows ? { ...arrows, cells: new Uint32Array(0) } : null,
        marks: marks ?? null,
        curves: curves ?? null,
      };
    });
  }

  /**
   * What colours now, and each quantity.
   *
   * @param {readonly string[]} metrics @param {Uint32Array} numbers of the cells that are there
   * @returns {Promise<Sheet["colours"]>}
   */
  #colours(metrics, numbers) {
    const app = this.#app;
    const { colour } = app.store.status;
    const now = colour.by === "quality" ? colour.metric : colour.by === "attribute" ? colour.attribute : "";
    const others = metrics.filter((id) => id !== now);
    const by = /** @type {const} */ ("quality");
    const poses = others.map((id) => ({ colour: { ...colour, by, ...chooseQuantity(id, app).colour } }));
    return posed(app, [{}, ...poses], async (k) => {
      const id = k ? others[k - 1] : (now ?? "");
      const metric = metricOf(app.tables, id);
      const shown = app.facts.get("colour");
      const scale = await app.figures.scale(BARS);
      const values = id ? await app.client.call("values", [id]) : null;
      return {
        id,
        name: metric?.name ?? (shown?.label || "Boundary and inside"),
        symbol: metric?.symbol ?? "",
        unit: unitOf(app.store.status, metric?.length_power ?? 0),
        colour: app.store.status.colour,
        positions: shown && Float32Array.from(numbers, (cell) => shown.map_position[cell]),
        high_first: shown?.high_first ?? false,
        values: values && Float32Array.from(numbers, (cell) => values[cell]),
        legend: scale ? textOf(legendAlone(scale, legendSize(scale), STYLE)) : "",
      };
    });
  }

  /** @param {Wanted} wanted @returns {Promise<Sheet["about"]>} */
  async #about({ reference, doi, link }) {
    const { facts, tables, saving, host } = this.#app;
    const entry = facts.get("entry");
    return {
      name: entry?.mesh.name ?? facts.get("summary")?.name ?? "",
      reference: reference || (entry ? inOneLine(entry.source) : ""),
      doi: reference ? (doi ?? "") : (entry?.source.doi ?? ""),
      link: link ?? (host.shares && location.protocol === "https:" ? await saving.link() : ""),
      cells: facts.get("summary")?.cells ?? 0,
      version: tables.version,
    };
  }

  /** The picture, as an address that holds it. */
  async #poster() {
    const { canvas, scene } = this.#app;
    await scene.settled();
    const scale = Math.min(1, POSTER / Math.max(canvas.clientWidth, canvas.clientHeight));
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((side) =>
      Math.max(1, Math.round(side * scale)),
    );
    const picture = await createImageBitmap(await scene.screenshot({ width, height }));
    const paper = new OffscreenCanvas(width, height);
    paper.getContext("2d")?.drawImage(picture, 0, 0);
    const blob = await paper.convertToBlob({ type: "image/webp", quality: QUALITY });
    return `data:${blob.type};base64,${toBase64(new Uint8Array(await blob.arrayBuffer()))}`;
  }
}

/** @param {NonNullable<import("../figure/compose.js").Figure["scale"]>} scale */
function legendSize(scale) {
  const { width, height, row } = LEGEND;
  return { width, height: "data" in scale ? height : (scale.colours.length + (scale.title ? 2 : 1)) * row };
}

/** A silhouette as a surface of no cells. @param {import("../geometry/records.js").Silhouette} silhouette @returns {import("../geometry/records.js").Surface} */
function plainQuads({ positions, normals }) {
  const count = positions.length / 3;
  return {
    mode: "lines",
    positions,
    normals,
    cells: new Uint32Array(count),
    inside: new Uint8Array(count),
    quads: null,
    faces: new Uint32Array(0),
    edges: new Float32Array(0),
    edge_cells: new Uint8Array(0),
    edge_faces: new Uint32Array(0),
    two_sided: false,
  };
}

/**
 * Cells numbered as they come in all surfaces, so that those that are never seen cost nothing.
 *
 * @param {Sheet["shots"]} shots @returns {{ cells: Sheet["shots"], numbers: Uint32Array }} numbers that they have in the mesh
 */
function renumbered(shots) {
  const seen = new Set();
  for (const { surface } of shots) for (const face of summed(surface.faces)) seen.add(face >>> 3);
  const numbers = Uint32Array.from(seen).sort();
  const places = new Map(Array.from(numbers, (cell, place) => [cell, place]));
  const place = (/** @type {number} */ cell) => places.get(cell) ?? 0;
  const cells = shots.map((shot) => ({ ...shot, surface: withCells(shot.surface, place) }));
  return { cells, numbers };
}

/** @param {Compact} surface @param {(cell: number) => number} place @returns {Compact} */
function withCells(surface, place) {
  const cells = steps(summed(surface.cells).map(place));
  const faces = summed(surface.faces).map((face) => place(face >>> 3) * 8 + (face & 7));
  return { ...surface, cells, faces: steps(faces) };
}

/**
 * The page's frame with everything in it.
 *
 * @param {string} shell @param {Sheet["about"]} about @param {string} poster @param {string} sheet
 */
function filled(shell, { name, reference }, poster, sheet) {
  /** @type {Record<string, string>} */
  const texts = { title: escaped(name), name: escaped(name), reference: escaped(reference), poster, sheet };
  const parts = shell.replace(PLACE, (mark, place) => texts[place] ?? mark);
  return new Blob([parts], { type: "text/html" });
}

/** @param {string} text */
function escaped(text) {
  return text.replace(/[&<>"']/g, (mark) => `&#${mark.charCodeAt(0)};`);
}
