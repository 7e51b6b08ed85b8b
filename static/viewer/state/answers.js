/**
 * What the core answers, as it comes through the door (hexalab.session). null stands for what is not known or not
 * finite. The tests hold these shapes against the answers of a real session.
 *
 * @typedef {[number, number, number]} Point
 *
 * @typedef {object} Summary  the quick part of what is known of a mesh
 * @property {string} name
 * @property {string} format
 * @property {number} vertices
 * @property {number} cells
 * @property {Record<string, number>} kinds number of cells of each
 * @property {number} boundary_faces
 * @property {[Point, Point]} extent in the file's unit
 * @property {[Point, Point]} frame the box that is drawn by: the extent, or that of the largest part
 * @property {Point} centre of the frame
 * @property {number} diagonal of the frame
 * @property {number} framed_cells cells within it
 * @property {View} view
 * @property {Float32Array} outline points that stand for the body when a camera is fitted to it, 3 coordinates each
 * @property {string[]} notes what was noted while it was read
 * @property {Attribute[]} attributes
 * @property {{ read: number, topology: number, summary: number }} timings milliseconds
 *
 * @typedef {object} View  where a mesh is looked at from
 * @property {Point} direction
 * @property {Point} up
 * @property {Point} facing normal of a plane that faces the eye
 *
 * @typedef {object} Attribute
 * @property {string} id
 * @property {string} name
 * @property {"cell" | "point"} on
 * @property {number} components of which it is the magnitude: 3 for a vector; 1 for a number
 * @property {number | null} min
 * @property {number | null} max
 *
 * @typedef {object} Description  the slow part, which comes part by part
 * @property {number} faces
 * @property {number} boundary_faces
 * @property {number} nonmanifold_faces
 * @property {number} edges
 * @property {Record<string, number>} interior_edge_valence number of edges by valence
 * @property {Record<string, number>} boundary_edge_valence
 * @property {number[]} cells_per_depth
 * @property {number} components
 * @property {number} max_depth
 * @property {number} unreferenced_vertices
 * @property {number} cells_repeating_a_vertex
 * @property {Record<string, number>} shapes number of cells by what they are or have collapsed to
 * @property {number[]} part_cells cells of each of the largest parts
 * @property {Finding[]} findings
 * @property {GroupRow[]} groups named sets of cells and of vertices, and what arrays of few whole numbers make
 * @property {Record<"corners" | "edges" | "faces", FeatureRows>} features elements of lower dimension
 *
 * @typedef {object} GroupRow
 * @property {string} id "elset:STEEL"
 * @property {string} name
 * @property {"cells" | "vertices"} kind
 * @property {string} origin
 * @property {number | null} number by which the file knows it
 * @property {number} count members
 *
 * @typedef {object} FeatureRows
 * @property {number} count
 * @property {number} lost those that are no vertex, edge or face of a cell
 * @property {FeatureGroup[]} groups
 *
 * @typedef {object} FeatureGroup
 * @property {string} id
 * @property {string} name
 * @property {string} origin
 * @property {number | null} number
 * @property {number} count
 * @property {number | null} colour row of the palette of marks; null of groups that none are coloured by
 *
 * @typedef {object} GroupMeasures  of a group of cells
 * @property {string} id
 * @property {number} volume
 * @property {number | null} scaled_jacobian_min
 * @property {number | null} scaled_jacobian_mean
 * @property {number} invalid cells whose Jacobian is somewhere not positive
 *
 * @typedef {object} Interface  where two groups meet
 * @property {[string | null, string | null]} groups null: cells in no group
 * @property {number} faces that both share
 * @property {number} apart faces of the one that lie on the other and are not joined to it
 * @property {number | null} colour row of the palette of marks
 *
 * @typedef {object} Numbers  how the file numbers cells
 * @property {number} first what rows are counted from where it does not
 * @property {Int32Array | Float64Array | null} cells
 *
 * @typedef {object} Found  by a number of the file
 * @property {number[]} rows that have it
 * @property {number} cell to look at, -1 if there is none
 * @property {Uint32Array} around rows of the cells around, itself among them
 * @property {Point} place in the file's unit
 *
 * @typedef {object} Finding  something that is wrong with a mesh, or worth knowing
 * @property {string} id
 * @property {"error" | "warning" | "note"} severity
 * @property {string} message
 * @property {number} count
 * @property {boolean} has_cells whether there are cells to be shown for it
 *
 * @typedef {object} Checked  a settings document that was checked
 * @property {PartialStatus} partial what of it applies
 * @property {Rejection[]} rejections
 * @property {"hexalab" | "original"} form
 *
 * @typedef {object} Rejection  a value of a settings document that can't be applied
 * @property {string} path
 * @property {string} found
 * @property {string} expected
 *
 * @typedef {object} Update  what is drawn otherwise than before: records that did not change are left out
 * @property {number} shown_cells
 * @property {number} shown_faces
 * @property {number | null} max_depth
 * @property {([number, number] | null)[]} plane_ranges
 * @property {string[]} pending records that wait for the description
 * @property {Record<string, number>} timings milliseconds
 * @property {Surface} [surface]
 * @property {Silhouette} [silhouette]
 * @property {Surface} [see_through] of hidden cells
 * @property {Irregular} [irregular]
 * @property {Arrows} [arrows]
 * @property {Marks} [marks]
 * @property {Curves} [curves]
 * @property {Silhouette} [reference] surface of what the mesh is compared with
 * @property {Colour | null} [colour] null for sides
 *
 * @typedef {import("../geometry/records.js").Surface} Surface
 * @typedef {import("../geometry/records.js").Silhouette} Silhouette
 * @typedef {import("../geometry/records.js").Irregular} Irregular
 * @typedef {import("../geometry/records.js").Arrows} Arrows
 * @typedef {import("../geometry/records.js").Marks} Marks
 * @typedef {import("../geometry/records.js").Curves} Curves
 * @typedef {Irregular["counts"]} IrregularCounts  number of irregular edges, interior and boundary, by valence
 *
 * @typedef {object} Colour
 * @property {Float32Array} map_position of each cell
 * @property {string} quantity
 * @property {string} label
 * @property {number | null} low value at the end of the map
 * @property {number | null} high
 * @property {boolean} high_first whether the map's first colour is that of high values
 * @property {{ id: string, colour: number }[]} [groups] where cells are coloured by group: row of the palette of each
 * @property {number} [without] cells in none of them
 * @property {number} [in_several] cells in several, which have the colour of the one of fewest members
 *
 * @typedef {object} SavedCells  the shown cells as a file
 * @property {Uint8Array} data
 * @property {number} cells
 * @property {number} vertices
 * @property {string[]} notes what its format has no place for
 *
 * @typedef {object} Report  of the open mesh
 * @property {string} text
 * @property {string} ending of a file that holds it, without the dot
 * @property {boolean} passed
 *
 * @typedef {object} ReportPose  a picture that a report asks for
 * @property {string} title what stands below it
 * @property {string} alt what is seen
 * @property {PartialStatus} status
 *
 * @typedef {object} Preview  summary and first picture of a mesh of the catalogue, packed when the site is built
 * @property {BriefSummary} summary
 * @property {number} shown_cells
 * @property {number} shown_faces
 * @property {Surface} surface
 * @property {Silhouette} [silhouette]
 * @property {Surface} [see_through] of hidden cells
 * @property {Irregular} [irregular]
 * @property {Arrows} [arrows]
 * @property {Marks} [marks]
 * @property {Curves} [curves]
 * @property {Colour | null} colour
 *
 * @typedef {object} BriefSummary
 * @property {string} name
 * @property {number} cells
 * @property {number} vertices
 * @property {[Point, Point]} extent
 * @property {[Point, Point]} frame
 * @property {Point} centre
 * @property {number} diagonal
 * @property {number} framed_cells
 * @property {View} view
 * @property {Float32Array} outline points that stand for the body when a camera is fitted to it, 3 coordinates each
 *
 * @typedef {object} Statistics  of a quantity over the cells
 * @property {string} id
 * @property {string} name
 * @property {string} symbol
 * @property {number} count
 * @property {number | null} min
 * @property {number | null} max
 * @property {number | null} mean
 * @property {number | null} median
 * @property {number | null} variance
 * @property {Record<string, number | null>} percentiles
 * @property {number} not_finite
 * @property {number} outside_acceptable
 * @property {number[]} worst cells
 * @property {number | null} low least finite value
 * @property {number | null} high
 * @property {Ends | null} acceptable_range
 * @property {Ends | null} full_range
 * @property {number | null} worst_value where the normalised quality is 0
 * @property {number | null} best_value
 *
 * @typedef {[number | null, number | null]} Ends  of a range; null: unbounded
 *
 * @typedef {object} Worst  the worst cells by a metric, or the highest by an attribute
 * @property {number[]} cells of finite value, the worst first
 * @property {number[]} values
 * @property {Point[]} places barycentres, in the file's unit
 * @property {number[]} not_finite cells without a finite value
 *
 * @typedef {object} Histogram
 * @property {string} quantity
 * @property {string} label
 * @property {Float64Array} edges bins + 1 values, rising
 * @property {Uint32Array} counts
 * @property {Float32Array} map_position of each bin's middle on the colour map
 * @property {number} low end of the axis
 * @property {number} high
 * @property {number} not_finite
 *
 * @typedef {object} Validity  number of cells that are certified to be so
 * @property {number} invalid
 * @property {number} valid
 * @property {number} undecided
 * @property {Uint32Array} invalid_cells
 *
 * @typedef {object} Inspection  everything about a cell
 * @property {number} cell its row
 * @property {number} number of the file
 * @property {string} kind
 * @property {number[]} corners rows of its vertices
 * @property {number[]} nodes the file's numbers of them
 * @property {string[]} groups ids of those that it is in
 * @property {Point[]} coordinates of the corners
 * @property {Record<string, number | null>} metrics those that its kind has
 * @property {string[]} pending metrics that wait for the mesh's mean volume
 * @property {Record<string, unknown>} attributes by name: a value, or a list of components
 * @property {number[]} neighbours six cells, -1 outside
 * @property {CellStructure | null} structure what it is part of; null until it is traced
 * @property {"invalid" | "valid" | "undecided"} validity
 *
 * @typedef {object} CellStructure
 * @property {number[]} sheets that cross it in its three directions; none where it is not traced
 * @property {number[]} chords that pass it
 * @property {number | null} block
 *
 * @typedef {object} Traced  how far the structure is
 * @property {number} done parts
 * @property {number} of
 * @property {string | null} next part; null after the last
 *
 * @typedef {object} StructureFacts  as `hexalab structure --json` prints them
 * @property {string} [skipped] what is not traced
 * @property {GraphFacts} irregular
 * @property {{ count: number, closed: number, self_intersecting: number, self_touching: number, one_sided: number }} sheets
 * @property {{ count: number, closed: number, self_intersecting: number }} chords
 * @property {BaseComplexFacts} base_complex
 * @property {{ blocks: number }} interior_base_complex
 * @property {string | null} class
 * @property {number | null} irregular_vertex_share
 * @property {Record<string, string>} [labels]
 *
 * @typedef {object} GraphFacts
 * @property {number} nodes
 * @property {number} nodes_inside
 * @property {number} arcs
 * @property {number} loops
 * @property {Record<string, number>} arcs_by_valence
 * @property {Record<string, number>} loops_by_valence
 * @property {Record<string, number>} node_types
 *
 * @typedef {object} BaseComplexFacts
 * @property {number} blocks
 * @property {number} vertices
 * @property {number} edges
 * @property {number} edge_loops
 * @property {number} faces
 * @property {Record<string, number>} kinds
 * @property {Record<string, number>} dims
 * @property {number} separation_faces
 * @property {number | null} cells_per_block
 * @property {number} base_sheets
 * @property {number} base_chords
 *
 * @typedef {object} StructureTable
 * @property {number} rows
 * @property {StructureColumn[]} columns
 *
 * @typedef {object} StructureColumn
 * @property {string} id
 * @property {Int32Array | Uint8Array} values
 * @property {string[] | null} words what the values stand for
 *
 * @typedef {object} SheetPairs  which sheets meet
 * @property {number} count of sheets
 * @property {Int32Array} one
 * @property {Int32Array} other
 * @property {Int32Array} crossings
 * @property {Int32Array} beside
 *
 * @typedef {{ centre: Point, size: number }} Around  a box, in drawing coordinates
 *
 * @typedef {object} CellValue  one value of a cell, as it is coloured by
 * @property {number} cell
 * @property {string} kind
 * @property {CellStructure | null} structure what it is part of; null until it is traced
 * @property {number | null} value
 * @property {(number | null)[] | null} components of which the value is the magnitude
 * @property {boolean} pending whether it waits for the mesh's mean volume
 *
 * @typedef {object} CellView
 * @property {Point} centre in drawing coordinates
 * @property {number} size
 * @property {Float32Array} edges both ends of each, 6 numbers for an edge
 *
 * @typedef {import("./status.js").PartialStatus} PartialStatus
 */

/**
 * What a comparison tells (SPEC S6, S7).
 *
 * @typedef {object} HandedOver  what the core of another mesh has to know of one
 * @property {string} name
 * @property {number} vertices
 * @property {number} cells
 * @property {Float64Array} points of the boundary: all x, then all y, then all z
 * @property {Int32Array} triangles of the boundary: all first corners, then the second, then the third
 * @property {number | null} volume
 * @property {Float64Array | null} coordinates of all vertices, if the cells are the same
 *
 * @typedef {object} Compared  what a mesh is compared with
 * @property {string} name
 * @property {boolean} same_cells
 * @property {string} difference what tells the cells apart; empty of a reference surface
 * @property {SurfaceFacts | null} surface of a reference surface
 * @property {Displacement | null} displacement where the cells are the same
 * @property {number} diagonal of the extent, that percents are of
 * @property {number | null} volume_ratio volume of the second over that of the first; null where one has none
 *
 * @typedef {object} SurfaceFacts
 * @property {string} file
 * @property {string} format
 * @property {number} vertices
 * @property {number} triangles
 * @property {[Point, Point]} extent
 * @property {number} area
 * @property {number | null} volume that it encloses, if it is closed
 * @property {boolean} closed
 * @property {string[]} notes
 *
 * @typedef {object} Displacement  of vertices, from the first mesh to the second
 * @property {number} moved
 * @property {number} max in the file's unit
 * @property {number} mean
 * @property {number} max_percent of the diagonal
 * @property {number} mean_percent
 *
 * @typedef {object} DistanceFacts  from the vertices of one surface to another surface
 * @property {number} vertices
 * @property {number} max in the file's unit
 * @property {number} mean
 * @property {number} rms
 * @property {number} max_percent of a diagonal
 * @property {number} mean_percent
 * @property {number} rms_percent
 * @property {Point} worst the vertex that is farthest away
 *
 * @typedef {{ there: DistanceFacts, back: DistanceFacts | null }} Distances
 *
 * @typedef {{ done: number, of: number }} Measured  vertices
 *
 * @typedef {object} Changes  of a metric, from the first mesh to the second
 * @property {number} worse cells
 * @property {number} better
 * @property {number} same
 * @property {number | null} largest_loss null where a value is not finite any more
 * @property {number[]} cells the file's numbers of those that got worse the most
 */

export {};
