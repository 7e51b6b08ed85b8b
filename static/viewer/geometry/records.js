/**
 * What the core sends to be drawn: its dataclasses of `hexalab.surface.records`, field by field, in the same order. Lengths
 * are in diagonals of the mesh's frame, whose centre is the origin.
 *
 * @typedef {object} Surface
 * @property {SeparationMode} mode
 * @property {Float32Array} positions 3 per vertex
 * @property {Int16Array} normals 4 per vertex, signed normalised, the fourth 0
 * @property {Uint32Array} cells 1 per vertex
 * @property {Uint8Array} inside 1 per vertex, 0 outside, 255 inside
 * @property {Uint32Array | null} quads 4 per face, or null where vertices stand four by four
 * @property {Uint32Array} faces 1 per face: cell * 8 + local face
 * @property {Float32Array} edges 6 per line
 * @property {Uint8Array} edge_cells 1 per line, or empty
 * @property {Uint32Array} edge_faces 2 per line: places in `faces` of those that meet there
 * @property {boolean} two_sided whether each face is there twice, to be seen from both of its sides
 *
 * @typedef {object} Silhouette
 * @property {Float32Array} positions
 * @property {Int16Array} normals
 *
 * @typedef {object} Irregular
 * @property {Float32Array} edges
 * @property {Uint8Array} valence
 * @property {Uint8Array} boundary
 * @property {Uint8Array} ends_on_boundary 1 for the first end, plus 2 for the second
 * @property {Float32Array} barbs
 * @property {Uint8Array} barb_valence
 * @property {Uint8Array} barb_boundary
 * @property {Float32Array} paper
 * @property {Uint8Array} paper_valence
 * @property {Uint8Array} paper_boundary interior ones stand first in every list
 * @property {Record<string, Record<string, number>>} counts of edges by "interior" and "boundary", and by valence
 *
 * @typedef {object} Curves of the structure, each with a row of styles (`colours/structure.js`)
 * @property {Float32Array} edges 6 per line
 * @property {Uint8Array} edge_rows
 * @property {Uint8Array} edge_faint 1 where something else was chosen
 * @property {Float32Array} points 3 per point
 * @property {Uint8Array} point_rows
 * @property {Uint8Array} point_faint
 *
 * @typedef {object} Arrows
 * @property {Float32Array} positions of the middles of faces, 3 each
 * @property {Float32Array} vectors 3 each, over the length of the attribute's longest
 * @property {Uint8Array} inward 1 where the vector points into the face's cell
 * @property {Uint32Array} cells that the faces belong to
 * @property {number | null} longest length of the longest vector in the file's unit
 * @property {number} not_finite faces without an arrow, as their vector is not finite
 * @property {number} zero faces without an arrow, as their vector is nothing beside the longest
 *
 * @typedef {object} Marks what is drawn over the surface, each with a row of the palette of marks
 * @property {Float32Array} faces 12 per face: corners four by four
 * @property {Uint8Array} face_colours
 * @property {Float32Array} edges 6 per line
 * @property {Uint8Array} edge_colours
 * @property {Float32Array} points 3 per point
 * @property {Uint8Array} point_colours
 * @property {Record<string, number>} counts
 *
 * @typedef {"lines" | "darkness_coded_edges" | "fissure" | "rounded"} SeparationMode
 *
 * @typedef {object} MeshFrame where a mesh stood before it was moved and scaled, and how large it is
 * @property {readonly (readonly number[])[]} [frame] two corners in the file's unit
 * @property {readonly number[]} [centre]
 * @property {number} [diagonal]
 * @property {ArrayLike<number>} [outline] points that stand for the body when a camera is fitted to it, 3 coordinates each
 * @property {number} cells number of cells of the whole mesh
 */

export {};
