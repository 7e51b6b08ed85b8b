import { trianglesOf } from "./shown_surface.js";

/**
 * Binary glTF 2.0 (Khronos Group, 2021): the surface with its colours and, where there are any, the lines between cells.
 *
 * Colours are what was seen, light and all: the material is unlit (KHR_materials_unlit). Geometry stays in drawing coordinates,
 * single precision about the origin; the node brings them to the file's unit and place, and what stands upright to +Y.
 *
 * @typedef {import("./shown_surface.js").ShownSurface} ShownSurface
 * @typedef {{ data: Float32Array | Uint16Array | Uint32Array, target: number, accessor: Record<string, unknown> }} Block
 */

const GLB = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;

/** Numbers of OpenGL that the format uses. */
const FLOAT = 5126;
const UNSIGNED_INT = 5125;
const UNSIGNED_SHORT = 5123;
const ARRAY_BUFFER = 34962;
const ELEMENT_ARRAY_BUFFER = 34963;
const LINES = 1;

/** Material of the lines. */
const INK = [0, 0, 0, 1];

/** @param {ShownSurface} surface @param {string} version of the program @returns {Uint8Array<ArrayBuffer>} */
export function toGlb(surface, version) {
  const { points, edges } = surface;
  const blocks = [
    vectors(points, true),
    vectors(floatNormals(surface.normals)),
    linearColours(surface.colours),
    indices(trianglesOf(surface.quads, points)),
    ...(edges.length ? [vectors(edges, true)] : []),
  ];
  const primitives = [
    { attributes: { POSITION: 0, NORMAL: 1, COLOR_0: 2 }, indices: 3, material: 0 },
    ...(edges.length ? [{ attributes: { POSITION: 4 }, mode: LINES, material: 1 }] : []),
  ];
  const { document, binary } = laidOut(blocks);
  const json = {
    asset: {
      version: "2.0",
      generator: `HexaLab ${version}`,
      ...(surface.reference ? { copyright: surface.reference } : {}),
    },
    extensionsUsed: ["KHR_materials_unlit"],
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ name: surface.name || "surface", mesh: 0, ...placed(surface.place) }],
    meshes: [{ primitives }],
    materials: [
      material("surface", [1, 1, 1, 1], true),
      ...(edges.length ? [material("lines", INK, false)] : []),
    ],
    ...document,
    buffers: [{ byteLength: binary.byteLength }],
  };
  return chunked(new TextEncoder().encode(JSON.stringify(json)), binary);
}

/** @param {string} name @param {readonly number[]} colour @param {boolean} doubleSided */
function material(name, colour, doubleSided) {
  return {
    name,
    pbrMetallicRoughness: { baseColorFactor: colour, metallicFactor: 0, roughnessFactor: 1 },
    extensions: { KHR_materials_unlit: {} },
    ...(doubleSided ? { doubleSided } : {}),
  };
}

/** @param {Float32Array} data 3 per vertex @param {boolean} [bounded] whether the least and greatest are told, as of positions @returns {Block} */
function vectors(data, bounded = false) {
  const accessor = { componentType: FLOAT, type: "VEC3", count: data.length / 3 };
  return {
    data,
    target: ARRAY_BUFFER,
    accessor: bounded ? { ...accessor, ...boundsOf(data) } : accessor,
  };
}

/** @param {Float32Array} data */
function boundsOf(data) {
  const [min, max] = [
    [Infinity, Infinity, Infinity],
    [-Infinity, -Infinity, -Infinity],
  ];
  for (let k = 0; k < data.length; k++) {
    min[k % 3] = Math.min(min[k % 3], data[k]);
    max[k % 3] = Math.max(max[k % 3], data[k]);
  }
  return { min, max };
}

/** @param {Int16Array} normals 4 per vertex */
function floatNormals(normals) {
  const out = new Float32Array((normals.length / 4) * 3);
  for (let from = 0, to = 0; from < normals.length; from += 4, to += 3) {
    const length = Math.hypot(normals[from], normals[from + 1], normals[from + 2]);
    for (let k = 0; k < 3; k++) out[to + k] = length ? normals[from + k] / length : k === 2 ? 1 : 0;
  }
  return out;
}

/** Linear light, as the format wants it: sixteen bits, of which eight would show in the dark. @param {Uint8Array} colours sRGB @returns {Block} */
function linearColours(colours) {
  const linear = Uint16Array.from({ length: 256 }, (_, byte) => Math.round(65535 * linearised(byte / 255)));
  const count = colours.length / 3;
  const data = new Uint16Array(4 * count).fill(65535);
  for (let k = 0; k < count; k++)
    for (let part = 0; part < 3; part++) data[4 * k + part] = linear[colours[3 * k + part]];
  return {
    data,
    target: ARRAY_BUFFER,
    accessor: { componentType: UNSIGNED_SHORT, normalized: true, type: "VEC4", count },
  };
}

/** sRGB's transfer function (IEC 61966-2-1). @param {number} part 0 to 1 */
function linearised(part) {
  return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
}

/** @param {Uint32Array} data @returns {Block} */
function indices(data) {
  return {
    data,
    target: ELEMENT_ARRAY_BUFFER,
    accessor: { componentType: UNSIGNED_INT, type: "SCALAR", count: data.length },
  };
}

/** Buffer views and accessors, one of each for a block. @param {readonly Block[]} blocks */
function laidOut(blocks) {
  const size = blocks.reduce((total, { data }) => total + data.byteLength, 0);
  const binary = new Uint8Array(size); // all of it words of four bytes
  let byteOffset = 0;
  const bufferViews = blocks.map(({ data, target }) => {
    binary.set(new Uint8Array(data.buffer, data.byteOffset, data.byteLength), byteOffset);
    const view = { buffer: 0, byteOffset, byteLength: data.byteLength, target };
    byteOffset += data.byteLength;
    return view;
  });
  const accessors = blocks.map(({ accessor }, bufferView) => ({ bufferView, ...accessor }));
  return { document: { bufferViews, accessors }, binary };
}

/** The node that brings drawing coordinates to the file's, upright. @param {import("./shown_surface.js").Place} place */
function placed({ centre, diagonal, up }) {
  const rotation = uprightBy(up);
  return { translation: rotated(centre, rotation), rotation, scale: [diagonal, diagonal, diagonal] };
}

/** The shortest turn that brings a direction to +Y, as a quaternion x y z w. @param {readonly number[]} up */
function uprightBy([x, y, z]) {
  const length = Math.hypot(x, y, z) || 1;
  if (y / length < -1 + 1e-9) return [1, 0, 0, 0];
  const turn = [-z / length, 0, x / length, 1 + y / length];
  const size = Math.hypot(...turn);
  return turn.map((part) => part / size || 0);
}

/** @param {readonly number[]} vector @param {readonly number[]} quaternion x y z w */
function rotated([x, y, z], [a, b, c, w]) {
  const t = [b * z - c * y, c * x - a * z, a * y - b * x].map((part) => 2 * part);
  return [
    x + w * t[0] + b * t[2] - c * t[1],
    y + w * t[1] + c * t[0] - a * t[2],
    z + w * t[2] + a * t[1] - b * t[0],
  ];
}

/** A file of two chunks, each padded to words: the text with spaces, the numbers with zeros. @param {Uint8Array} json @param {Uint8Array} binary @returns {Uint8Array<ArrayBuffer>} */
function chunked(json, binary) {
  const padded = (/** @type {number} */ size) => Math.ceil(size / 4) * 4;
  const [text, numbers] = [padded(json.length), padded(binary.length)];
  const out = new Uint8Array(12 + 8 + text + 8 + numbers);
  const view = new DataView(out.buffer);
  [GLB, 2, out.length, text, JSON_CHUNK].forEach((word, k) => view.setUint32(4 * k, word, true));
  out.fill(0x20, 20, 20 + text).set(json, 20);
  view.setUint32(20 + text, numbers, true);
  view.setUint32(24 + text, BIN_CHUNK, true);
  out.set(binary, 28 + text);
  return out;
}
