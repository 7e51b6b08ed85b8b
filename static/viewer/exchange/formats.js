import { toGlb } from "./gltf.js";
import { toObj } from "./obj.js";
import { toPly } from "./ply.js";
import { toStl } from "./stl.js";

/**
 * Formats in which the shown surface leaves the page.
 *
 * @typedef {object} SurfaceFormat
 * @property {string} id which is the ending of its files, too
 * @property {string} name
 * @property {boolean} coloured whether it has a place for colours
 * @property {string} type of its content
 * @property {(surface: import("./shown_surface.js").ShownSurface, version: string) => Uint8Array<ArrayBuffer>} write
 */

/** @type {readonly SurfaceFormat[]} */
export const SURFACE_FORMATS = [
  { id: "glb", name: "glTF binary", coloured: true, type: "model/gltf-binary", write: toGlb },
  { id: "ply", name: "PLY", coloured: true, type: "application/octet-stream", write: toPly },
  { id: "obj", name: "Wavefront OBJ", coloured: true, type: "model/obj", write: toObj },
  { id: "stl", name: "STL", coloured: false, type: "model/stl", write: toStl },
];
