/**
 * @typedef {{ arrows: import("../geometry/records.js").Arrows, marks: import("../geometry/records.js").Marks,
 *   curves: import("../geometry/records.js").Curves, reference: import("../geometry/records.js").Silhouette,
 *   seeThrough: import("../geometry/records.js").Surface, irregular: import("../geometry/records.js").Irregular }} Over
 *
 * What the viewer knows of a scene, so that one which draws nothing can stand in for it.
 *
 * @typedef {object} Place of the canvas
 * @property {number} x CSS pixels from its left
 * @property {number} y from its top
 *
 * @typedef {object} FaceHit
 * @property {number} face cell * 8 + local face
 * @property {number} cell
 * @property {number} localFace
 *
 * @typedef {object} DrawnCounts
 * @property {number} faces
 * @property {number} triangles
 * @property {number} edges
 * @property {number} cells
 *
 * @typedef {object} PictureOptions
 * @property {number} [width] pixels; the canvas's
 * @property {number} [height]
 * @property {boolean} [transparent] whether the background is
 *
 * @typedef {object} SceneEvents what listeners of each event are told
 * @property {import("./types.js").CameraStatus} camera at every move
 * @property {import("./types.js").CameraStatus} cameraend when a move ends
 * @property {Place & { event: PointerEvent }} click
 * @property {Place & { event: PointerEvent } | null} hover null: the pointer is nowhere on the canvas
 * @property {Place | null} marked rightmost place of the marked cell, when that has changed; null: nowhere in sight
 * @property {void} blank a double click where nothing is
 * @property {void} calm nothing is held any more, or has not moved for long
 * @property {void} contextlost
 * @property {void} contextrestored
 *
 * @typedef {object} SceneLike
 * @property {Record<string, number>} timings milliseconds of the last upload, picture, first and whole lighting
 * @property {Pick<import("../lighting/lighting.js").LightingLike, "baked">} lighting
 * @property {number} frames pictures drawn since the scene was made
 * @property {boolean} hurried whether surfaces are wanted fast rather than whole
 * @property {boolean} outward whether every cell is valid at its corners: then the backs of faces need not be drawn
 * @property {<Name extends keyof SceneEvents>(name: Name, listener: (detail: SceneEvents[Name]) => void) => () => void} on
 *   what it returns takes the listener off
 * @property {() => Promise<void>} prepare
 * @property {(mesh: import("../geometry/records.js").MeshFrame) => void} setMesh
 * @property {(points: Float32Array | null) => void} setBeside points of another body that is seen beside the mesh, 3 coordinates
 *   each: the camera is fitted to both
 * @property {(surface: import("../geometry/records.js").Surface | null, same?: boolean) => void} setSurface
 * @property {(silhouette: import("../geometry/records.js").Silhouette | null) => void} setSilhouette
 * @property {<Name extends keyof Over>(layer: Name, record: Over[Name] | null) => void} setOver what is drawn over the surface
 * @property {(positions: Float32Array | null, highFirst?: boolean) => void} setCellColours in the colour map, one per cell; whether its first
 *   colour is that of high values
 * @property {(status: import("./types.js").SceneStatus) => void} setStatus
 * @property {(width: number, height: number, pixelRatio?: number) => void} resize
 * @property {(x: number, y: number) => FaceHit | null} pick
 * @property {(face: number | null) => void} highlight
 * @property {(edges: Float32Array | null) => void} mark outlines a cell
 * @property {number} covered CSS pixels at the right of the canvas that something covers
 * @property {(plane: import("./types.js").Plane | null) => void} showPlane
 * @property {import("./types.js").CameraStatus} camera as it stands at the moment
 * @property {(filled?: number) => Partial<import("./types.js").CameraStatus> | null} cameraOnShown that sees what is shown whole, from
 *   the present direction; null where nothing is
 * @property {(aspect: number) => number} halfHeight of what a picture of a shape sees, at the target's distance, in diagonals
 * @property {() => void} rest nothing is drawn on the canvas until somebody waits for it
 * @property {() => Promise<void>} settled when the picture is drawn and will not change by itself
 * @property {(options?: PictureOptions) => Promise<Blob>} screenshot
 * @property {() => DrawnCounts} drawn
 * @property {() => void} invalidate
 * @property {() => void} flush
 * @property {() => void} dispose
 */

export {};
