import { cellColours } from "../colours/cell_colour.js";
import { SURFACE_FORMATS } from "../exchange/formats.js";
import { shownSurface } from "../exchange/shown_surface.js";
import { inOneLine } from "../state/entry.js";

/**
 * @typedef {import("../state/leaving.js").Left} Left
 * @typedef {import("../state/leaving.js").CellsWanted} CellsWanted
 * @typedef {import("../state/leaving.js").SurfaceWanted} SurfaceWanted
 */

/** Coordinates so many times as large as the body lose digits in single precision that the body needs: a millionth of it. */
const FAR = 8;

/** The shown cells and their surface, as files of formats that other programs read (SPEC A8). */
export class Leaving {
  #app;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /**
   * The shown cells as a mesh.
   *
   * @param {string} format a row of the writers @param {CellsWanted} [wanted] @returns {Promise<Left & { cells: number }>}
   */
  async cells(format, { metrics = [], attributes = null, structure = false } = {}) {
    const { client, drawing, tables } = this.#app;
    const writer = tables.writers.find(({ id }) => id === format);
    if (!writer) throw new Error(unknown(format, tables.writers));
    await drawing.drawn();
    const { data, notes, cells } = await client.call("save_cells", [format, metrics, attributes, structure]);
    const file = new Blob([/** @type {Uint8Array<ArrayBuffer>} */ (data)]);
    return { file, ending: writer.extension.slice(1), notes, cells };
  }

  /** The shown surface. @param {string} format a row of `SURFACE_FORMATS` @param {SurfaceWanted} [wanted] @returns {Promise<Left>} */
  async surface(format, { light = this.lit, reference } = {}) {
    const { store, facts, scene, drawing, tables } = this.#app;
    const row = SURFACE_FORMATS.find(({ id }) => id === format);
    if (!row) throw new Error(unknown(format, SURFACE_FORMATS));
    await drawing.drawn();
    await scene.settled();
    const { surface } = drawing.records;
    const summary = facts.get("summary");
    if (!surface?.faces.length || !summary) throw new Error("no cell is shown: there is nothing to save");
    const { status } = store;
    const [colour, entry] = [facts.get("colour"), facts.get("entry")];
    const values = colour && { positions: colour.map_position, highFirst: colour.high_first };
    const openness = light && row.coloured ? await scene.lighting.baked() : null;
    if (openness && drawing.records.surface !== surface)
      throw new Error("the picture changed while its light was gathered: save again");
    const { centre = [0, 0, 0], diagonal = 1, view } = summary;
    const shown = shownSurface(
      { surface, colourOf: cellColours(status.colour, values), openness, shade: status.lighting.shade },
      {
        place: { centre, diagonal, up: view.up },
        name: summary.name,
        reference: reference ?? (entry ? inOneLine(entry.source) : ""),
      },
    );
    const file = new Blob([await row.write(shown, tables.version)], { type: row.type });
    return { file, ending: row.id, notes: format === "stl" ? precision(centre, diagonal) : [] };
  }

  /** Whether the picture's light comes from all around, and so can be kept. */
  get lit() {
    return this.#app.store.status.lighting.mode.endsWith("_ao");
  }
}

/** @param {readonly number[]} centre @param {number} diagonal */
function precision(centre, diagonal) {
  const digits = Math.max(...centre.map(Math.abs)) / diagonal;
  return digits > FAR
    ? [
        `STL has single precision: so far from the origin, points are rounded by up to ${(digits * diagonal * 2 ** -24).toPrecision(1)}.`,
      ]
    : [];
}

/** @param {string} format @param {readonly { id: string }[]} rows */
function unknown(format, rows) {
  return `found the format ‘${format}’, expected one of ${rows.map(({ id }) => id).join(", ")}`;
}
