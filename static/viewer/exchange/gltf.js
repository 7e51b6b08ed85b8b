import {
  BufferAttribute,
  BufferGeometry,
  Group,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  Vector3,
} from "three";
import { GLTFExporter } from "three/examples/jsm/exporters/GLTFExporter.js";
import { trianglesOf } from "./shown_surface.js";

/** What glTF has upright. */
const UP = new Vector3(0, 1, 0);

/**
 * Binary glTF 2.0: the surface with its colours and, where there are any, the lines between cells.
 *
 * Colours are what was seen, light and all: the materials are unlit (KHR_materials_unlit). Geometry stays in drawing coordinates,
 * single precision about the origin; the node brings them to the file's unit and place, and what stands upright to +Y.
 *
 * @param {import("./shown_surface.js").ShownSurface} surface @param {string} version of the program @returns {Promise<Uint8Array<ArrayBuffer>>}
 */
export async function toGlb(surface, version) {
  const { centre, diagonal, up } = surface.place;
  const node = new Group();
  node.name = surface.name || "surface";
  node.userData = { generator: `HexaLab ${version}`, reference: surface.reference };
  node.quaternion.setFromUnitVectors(new Vector3().fromArray(up).normalize(), UP);
  node.position.fromArray(centre).applyQuaternion(new Quaternion().copy(node.quaternion));
  node.scale.setScalar(diagonal);
  node.add(facesOf(surface));
  if (surface.edges.length) node.add(linesOf(surface));
  const made = await new GLTFExporter().parseAsync(node, {
    binary: true,
    trs: true,
    includeCustomExtensions: true,
  });
  return new Uint8Array(/** @type {ArrayBuffer} */ (made));
}

/** @param {import("./shown_surface.js").ShownSurface} surface */
function facesOf({ points, normals, colours, quads }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setAttribute("normal", new BufferAttribute(floatNormals(normals), 3));
  geometry.setAttribute("color", new BufferAttribute(linearColours(colours), 4, true));
  geometry.setIndex(new BufferAttribute(trianglesOf(quads, points), 1));
  const faces = new Mesh(geometry, new MeshBasicMaterial({ name: "faces", vertexColors: true, side: 2 }));
  faces.name = "faces";
  return faces;
}

/** @param {import("./shown_surface.js").ShownSurface} surface */
function linesOf({ edges }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(edges, 3));
  const lines = new LineSegments(geometry, new MeshBasicMaterial({ name: "lines", color: 0 }));
  lines.name = "lines";
  return lines;
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

/** Linear light, as the format wants it: sixteen bits, of which eight would show in the dark. @param {Uint8Array} colours sRGB */
function linearColours(colours) {
  const linear = Uint16Array.from({ length: 256 }, (_, byte) => Math.round(65535 * linearised(byte / 255)));
  const count = colours.length / 3;
  const out = new Uint16Array(4 * count).fill(65535);
  for (let k = 0; k < count; k++)
    for (let part = 0; part < 3; part++) out[4 * k + part] = linear[colours[3 * k + part]];
  return out;
}

/** sRGB's transfer function (IEC 61966-2-1). @param {number} part 0 to 1 */
function linearised(part) {
  return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
}
