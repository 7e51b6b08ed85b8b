/**
 * The shapes of what the scene is given. Lengths are in diagonals of the mesh, whose extent's centre is the origin.
 *
 * @typedef {object} MeshFrame
 * @property {number[][]} [extent] two corners in the file's unit
 * @property {number[]} [centre]
 * @property {number} [diagonal]
 * @property {number} cells number of cells of the whole mesh
 *
 * @typedef {"lines" | "darkness_coded_edges" | "fissure" | "rounded"} SeparationMode
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
 *
 * @typedef {object} Silhouette
 * @property {Float32Array} positions
 * @property {Int16Array} normals
 *
 * @typedef {object} Irregular
 * @property {Float32Array} edges
 * @property {Uint8Array} valence
 * @property {Uint8Array} boundary
 * @property {Float32Array} barbs
 * @property {Uint8Array} barb_valence
 * @property {Uint8Array} barb_boundary
 * @property {Float32Array} paper
 * @property {Uint8Array} paper_valence
 * @property {Uint8Array} paper_boundary interior ones stand first in every list
 *
 * @typedef {import("../state/status.js").Status["camera"]} CameraStatus
 *
 * @typedef {object} ColourStatus
 * @property {"sides" | "quality" | "attribute" | "kind"} by
 * @property {string} outside
 * @property {string} inside
 * @property {string} map
 *
 * @typedef {object} SceneStatus the part of the status document that the scene draws
 * @property {CameraStatus} [camera]
 * @property {{ line_opacity?: number, line_width?: number }} [separation]
 * @property {Partial<ColourStatus>} [colour]
 * @property {number} [silhouette]
 * @property {{ mode?: number, boundary?: boolean }} [irregular]
 * @property {{ mode?: LightingMode }} [lighting]
 * @property {string} [background]
 *
 * @typedef {"none" | "direct" | "screen_space_ao" | "object_space_ao"} LightingMode
 *
 * @typedef {object} Plane
 * @property {readonly number[]} normal
 * @property {number} offset from 0 to 1 over the extent
 * @property {readonly number[]} [extent] least and greatest distance from the origin along the normal, in diagonals; the mesh's box
 */

/**
 * Stand-in for the type that Scene and BlankScene share: what the application and the page use of it.
 *
 * @typedef {{ x: number, y: number, event: PointerEvent }} At
 * @typedef {{ camera: CameraStatus, cameraend: null, click: At, hover: At | null, calm: null, contextlost: null, contextrestored: null }} SceneEvents
 *
 * @typedef {object} SceneLike
 * @property {Record<string, number>} timings
 * @property {boolean} hurried
 * @property {boolean} outward
 * @property {number} frames
 * @property {() => void} warmUp
 * @property {(mesh: MeshFrame) => void} setMesh
 * @property {(surface: Surface | null, same?: boolean) => void} setSurface
 * @property {(silhouette: Silhouette | null) => void} setSilhouette
 * @property {(irregular: Irregular | null) => void} setIrregular
 * @property {(positions: Float32Array | null) => void} setCellColours
 * @property {(status: SceneStatus) => void} setStatus
 * @property {(width: number, height: number, pixelRatio?: number) => void} resize
 * @property {(face: number | null) => void} highlight
 * @property {(plane: Plane | null) => void} showPlane
 * @property {() => void} flush
 * @property {(x: number, y: number) => { face: number, cell: number, localFace: number } | null} pick
 * @property {<Name extends keyof SceneEvents>(name: Name, listener: (detail: SceneEvents[Name]) => void) => () => void} on
 * @property {() => Promise<void>} settled
 * @property {() => { faces: number, triangles: number, edges: number, cells: number }} drawn
 * @property {(options?: { width?: number, height?: number, transparent?: boolean }) => Promise<Blob>} screenshot
 */

export {};
