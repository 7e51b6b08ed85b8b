import { ROWS } from "./numbering.js";

/**
 * @typedef {import("./answers.js").BriefSummary & Partial<import("./answers.js").Summary>} MeshSummary
 *   of a mesh whose preview alone is there, the brief one
 *
 * @typedef {"dig" | "undig" | "isolate"} PickingTool
 * @typedef {"turn" | PickingTool} Tool
 *
 * @typedef {object} Message
 * @property {number} id
 * @property {"error" | "warning" | "note"} severity
 * @property {string} text
 * @property {{ name: string, press: () => void }} [action]
 * @property {string} [topic]
 *
 * @typedef {object} Hover  the cell under the pointer, and after a while what is known of it
 * @property {number} cell
 * @property {string} [kind]
 * @property {string} [name] of the quantity looked at
 * @property {number | null} [value]
 * @property {string} [unit] of the value; may be empty
 * @property {import("./answers.js").CellStructure | null} [structure] what it is part of, once that is traced
 * @property {readonly (number | null)[] | null} [components] of which the value is the magnitude
 *
 * @typedef {object} Apart  how far two surfaces are apart
 * @property {import("./answers.js").DistanceFacts} a_to_b
 * @property {import("./answers.js").DistanceFacts} b_to_a
 * @property {number} hausdorff the larger of both largest
 * @property {number} hausdorff_percent of the first one's diagonal
 *
 * @typedef {object} Portrait  stands in for a mesh that is on its way
 * @property {import("./entry.js").Entry} entry
 * @property {HTMLImageElement} image
 * @property {{ width: number, height: number }} taken of the picture by the body, from 0 to 1
 * @property {{ width: number, height: number } | null} size that it has upon the canvas, once the mesh is known: its body is then
 *   exactly where that of the mesh is
 * @property {boolean} aside of the mesh that is open, which stays on the screen until then
 *
 * @typedef {object} FactTable  the facts by name
 * @property {"starting" | "ready" | "failed"} core
 * @property {Tool} tool what a click on the picture does
 * @property {readonly Message[]} messages
 * @property {{ text: string, fraction: number | null } | null} progress
 * @property {Readonly<Record<string, number>>} timings milliseconds
 * @property {{ name: string, entries: import("../files/zip.js").Entry[], count: number } | null} archive of meshes, offered as a batch
 * @property {import("./entry.js").Index | null} catalogue
 * @property {import("./entry.js").CatalogueSource | null} source chosen from the catalogue
 * @property {import("./entry.js").Entry | null} entry of the open mesh
 * @property {string} address that the open mesh was fetched from; empty for a file
 * @property {readonly { id: string, name: string, surface?: boolean }[]} offers meshes, and surfaces to measure against, that the core has at hand
 * @property {string | null} offered the open mesh, if it is one of these
 * @property {"kept" | "free" | "coming" | null} offline whether this browser keeps the open mesh until it is freed; null where it can't
 * @property {Portrait | null} portrait of the mesh that is being fetched, if it has one
 * @property {MeshSummary | null} summary of the open mesh, null while there is none
 * @property {Partial<import("./answers.js").Description> | null} description
 * @property {Readonly<Record<string, import("./answers.js").Statistics>>} statistics by quantity
 * @property {import("./answers.js").Histogram & { asked: string } | null} histogram with what it was asked for under
 * @property {import("./answers.js").Worst & { quantity: string } | null} worst cells by what is looked at
 * @property {import("./answers.js").IrregularCounts | null} irregular
 * @property {import("./arrows.js").Told | null} arrows that are drawn
 * @property {Readonly<Record<string, number>>} marks that are drawn over the surface, by what was asked for
 * @property {import("./numbering.js").Numbering} numbering of the cells, by the file
 * @property {Readonly<Record<string, import("./answers.js").GroupMeasures>> | null} groupMeasures by id, once they were asked for
 * @property {{ origin: string, rows: readonly import("./answers.js").Interface[] } | null} interfaces between groups of an origin
 * @property {import("./answers.js").Traced | null} tracing how far the structure is, while it is traced
 * @property {import("./answers.js").StructureFacts | null} structure once it is traced
 * @property {{ cells: number, faces: number } | null} shown
 * @property {import("./answers.js").Colour | null} colour
 * @property {number | null} layers of cells from the boundary inwards
 * @property {import("./answers.js").Inspection | null} cell in the inspector
 * @property {boolean} flown whether the cell in the inspector was flown to: then it stands beside the inspector
 * @property {Hover | null} hover
 * @property {number} plane number of the one at hand
 * @property {boolean} planeShown while its slider is held
 * @property {import("./answers.js").Update["plane_ranges"]} planeRanges
 * @property {import("./opening_view.js").Keeping} keeping whether another mesh keeps the view
 * @property {string} changed what was set while its control is folded away, in words
 * @property {boolean} posing while settings change for the pictures of a figure, to be what they were
 * @property {boolean} remember whether the last files are kept in this browser
 * @property {{ name: string, press: () => unknown } | null} again the files that were open when the page was left
 * @property {{ width: number, height: number } | null} canvas its size in CSS pixels, once that is known
 * @property {string | null} lack why this browser keeps nothing for when there is no network; empty where it does, null while that is not known
 * @property {import("./answers.js").Compared | null} comparison what the mesh is compared with, once both know of each other
 * @property {Facts | null} second what is known of the second mesh
 * @property {boolean} together whether both are seen at the same place
 * @property {Apart | null} apart once it was measured
 * @property {import("./answers.js").Measured | null} measuring while that is measured
 * @property {import("./quality_filter.js").Keep | null} keep chosen while the quality filter hides nothing yet
 */

/** What is known of a mesh before anything is, and the tool at hand: another mesh starts with these. */
export const NEW_MESH = Object.freeze(
  /** @type {Pick<FactTable, "tool" | "source" | "entry" | "address" | "offered" | "summary" | "description" | "statistics" | "histogram" | "worst" | "irregular" | "arrows" | "marks" | "numbering" | "groupMeasures" | "interfaces" | "tracing" | "structure" | "shown" | "colour" | "layers" | "cell" | "flown" | "hover" | "plane" | "planeRanges">} */ ({
    tool: "turn",
    source: null,
    entry: null,
    address: "",
    offered: null,
    summary: null,
    description: null,
    statistics: {},
    histogram: null,
    worst: null,
    irregular: null,
    arrows: null,
    marks: {},
    numbering: ROWS,
    groupMeasures: null,
    interfaces: null,
    tracing: null,
    structure: null,
    shown: null,
    colour: null,
    layers: null,
    cell: null,
    flown: false,
    hover: null,
    plane: 0,
    planeRanges: [],
  }),
);

/** What is known before anything is. @type {FactTable} */
const NOTHING = {
  ...NEW_MESH,
  core: "starting",
  messages: [],
  progress: null,
  portrait: null,
  timings: {},
  archive: null,
  catalogue: null,
  offers: [],
  planeShown: false,
  keeping: "changed",
  changed: "",
  posing: false,
  remember: true,
  again: null,
  canvas: null,
  offline: null,
  lack: null,
  comparison: null,
  second: null,
  together: false,
  apart: null,
  measuring: null,
  keep: null,
};

/**
 * What is known at the moment and is not a setting: the mesh's summary, what the core is doing, which cell is
 * inspected, messages. Panels listen to single facts by name.
 *
 *     facts.on("summary", (summary) => show(summary));
 *     facts.set({ summary });
 */
export class Facts {
  #values;
  /** @type {Map<string, Set<(value: unknown) => void>>} */ #listeners = new Map();

  /** @param {Partial<FactTable>} [initial] */
  constructor(initial = {}) {
    this.#values = { ...NOTHING, ...initial };
  }

  /** @template {keyof FactTable} Name @param {Name} name @returns {FactTable[Name]} */
  get(name) {
    return this.#values[name];
  }

  /** @param {Partial<FactTable>} values */
  set(values) {
    const before = /** @type {Readonly<Record<string, unknown>>} */ (this.#values);
    const changed = Object.entries(values).filter(([name, value]) => !Object.is(before[name], value));
    this.#values = { ...this.#values, ...values };
    for (const [name, value] of changed) {
      for (const listener of [...(this.#listeners.get(name) ?? [])]) listener(value);
    }
  }

  /**
   * @template {keyof FactTable} Name
   * @param {Name} name @param {(value: FactTable[Name]) => void} listener
   * @returns {() => void} stops listening
   */
  on(name, listener) {
    const own = /** @type {(value: unknown) => void} */ (listener);
    const all = this.#listeners.get(name) ?? new Set();
    this.#listeners.set(name, all.add(own));
    return () => void all.delete(own);
  }
}
