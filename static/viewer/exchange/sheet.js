/**
 * What a page of one file holds of a mesh. Cells are numbered anew: those that no surface shows are not there.
 *
 * @typedef {object} Sheet
 * @property {import("../state/status.js").PartialStatus & { camera: import("../state/status.js").Status["camera"] }} status what the scene draws by
 * @property {import("../geometry/records.js").MeshFrame} mesh
 * @property {import("./compact_irregular.js").CompactIrregular | null} irregular
 * @property {readonly Shot[]} shots one for each slice, one at least
 * @property {readonly Colouring[]} colours one at least
 * @property {Int32Array} numbers of the cells in the whole mesh, as steps
 * @property {About} about
 *
 * @typedef {object} Shot  what is shown under one slice
 * @property {number | null} slice how far in it is, 0 to 1; null where none was asked for
 * @property {number} cells shown
 * @property {import("./compact_surface.js").Compact} surface
 * @property {Uint8Array} openness of its vertices to light, 0 to 255; none where light is not kept
 * @property {import("./compact_surface.js").Compact | null} silhouette
 * @property {import("./compact_surface.js").Compact | null} see_through
 * @property {import("../geometry/records.js").Arrows | null} arrows
 * @property {import("../geometry/records.js").Marks | null} marks
 * @property {import("../geometry/records.js").Curves | null} curves
 *
 * @typedef {object} Colouring
 * @property {string} id of the quantity; empty for sides and categories
 * @property {string} name
 * @property {string} symbol
 * @property {string} unit of the values; may be empty
 * @property {import("../state/status.js").Status["colour"]} colour
 * @property {Float32Array | null} positions of the cells on the map; null for sides
 * @property {boolean} high_first
 * @property {Float32Array | null} values of the cells
 * @property {string} legend an SVG; may be empty
 *
 * @typedef {object} About
 * @property {string} name of the mesh
 * @property {string} reference where it is from; may be empty
 * @property {string} doi of the paper; may be empty
 * @property {string} link to the full viewer; may be empty
 * @property {number} cells of the whole mesh
 * @property {string} version of the program
 */

/** A place in the page's frame that is filled when the page is made: title, name, reference, poster, sheet. */
export const PLACE = /@@(\w+)@@/g;
