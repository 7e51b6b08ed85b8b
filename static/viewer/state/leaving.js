/**
 * What can be asked of files that leave the page, other than pictures (SPEC A7, A8).
 *
 * @typedef {object} Left  a file that leaves the page
 * @property {Blob} file
 * @property {string} ending of its name, without the dot
 * @property {readonly string[]} notes what it lacks, a sentence each
 * @property {string} [part] what its name says after the mesh's
 *
 * @typedef {object} CellsWanted
 * @property {readonly string[]} [metrics] that become attributes of the cells
 * @property {readonly string[] | null} [attributes] of the file that come along; null: all
 * @property {boolean} [structure] whether sheets, chords, block and distance to irregular edges come along
 *
 * @typedef {object} SurfaceWanted
 * @property {boolean} [light] whether it is in the colours; without, where it comes from all around
 * @property {string} [reference] where the mesh is from; without, what the catalogue says
 *
 * @typedef {object} PageWanted
 * @property {readonly string[]} [metrics] quantities to colour by besides what colours now, by their ids
 * @property {readonly number[]} [slices] how far the first slice goes in, 0 to 1, a surface each; as it is now without
 * @property {string} [reference] where the mesh is from; without, what the catalogue says
 * @property {string} [doi] of the paper, where there is a reference
 * @property {string} [link] address of the full viewer on this mesh; this page's own without, if others can open that
 *
 * @typedef {"zip" | "webm" | "mp4"} TurnFormat  an archive of pictures, or a video
 *
 * @typedef {object} Turn
 * @property {TurnFormat} [format]
 * @property {number} [frames] of the whole turn
 * @property {number} [seconds] that a video takes
 * @property {number} [width] pixels; the canvas's
 * @property {number} [height]
 * @property {AbortSignal} [signal]
 * @property {(done: number, of: number) => void} [report]
 *
 * @typedef {object} Leaving
 * @property {boolean} lit whether the picture's light comes from all around, and so can be kept
 * @property {(format: string, wanted?: CellsWanted) => Promise<Left>} cells
 * @property {(format: string, wanted?: SurfaceWanted) => Promise<Left>} surface
 *
 * @typedef {{ file: (wanted?: PageWanted) => Promise<Blob> }} SinglePage
 * @typedef {{ file: (turn?: Turn) => Promise<Blob> }} Turntable
 *
 * @typedef {{ sha256: string, unit: string, notes?: readonly string[] }} ReportAbout  what the core does not know of the file
 * @typedef {{ title: string, alt: string, address: string }} ReportPicture  address: a data URI
 *
 * @typedef {object} ReportWanted
 * @property {unknown} [criteria] what the mesh has to hold, as a file of criteria has it; null: none
 * @property {boolean} [strict] whether the errors of the diagnosis count beside criteria
 * @property {boolean} [pictures] whether a page has them
 *
 * @typedef {{ file: (form?: string, wanted?: ReportWanted) => Promise<Left & { passed: boolean }> }} Reports
 */

/** Each slice of a page brings a surface, each quantity a number for each cell. */
export const MOST_SLICES = 24;
export const MOST_METRICS = 12;

/** Pictures of a turntable, and seconds of its video, where nothing else is asked for; and at most. */
export const FRAMES = 72;
export const MOST_FRAMES = 720;
export const SECONDS = 6;
export const MOST_SECONDS = 120;
