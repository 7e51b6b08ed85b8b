/**
 * Formats in which the shown surface leaves the page. glTF and STL are written by three's exporters; PLY and OBJ here, since those
 * know neither faces of four corners nor double precision.
 *
 * @typedef {import("./shown_surface.js").ShownSurface} ShownSurface
 *
 * @typedef {object} SurfaceFormat
 * @property {string} id which is the ending of its files, too
 * @property {string} name
 * @property {boolean} coloured whether it has a place for colours
 * @property {string} type of its content
 * @property {(surface: ShownSurface, version: string) => Promise<Uint8Array<ArrayBuffer>>} write
 */

/** @type {readonly SurfaceFormat[]} */
export const SURFACE_FORMATS = [
  {
    id: "glb",
    name: "glTF binary",
    coloured: true,
    type: "model/gltf-binary",
    write: async (surface, version) => (await import("./gltf.js")).toGlb(surface, version),
  },
  {
    id: "ply",
    name: "PLY",
    coloured: true,
    type: "application/octet-stream",
    write: async (surface) => (await import("./ply.js")).toPly(surface),
  },
  {
    id: "obj",
    name: "Wavefront OBJ",
    coloured: true,
    type: "model/obj",
    write: async (surface) => (await import("./obj.js")).toObj(surface),
  },
  {
    id: "stl",
    name: "STL",
    coloured: false,
    type: "model/stl",
    write: async (surface) => (await import("./stl.js")).toStl(surface),
  },
];
