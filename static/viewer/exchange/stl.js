import { BufferAttribute, BufferGeometry, Mesh } from "three";
import { STLExporter } from "three/examples/jsm/exporters/STLExporter.js";
import { trianglesOf } from "./shown_surface.js";

/** Binary STL: triangles in the file's coordinates, single precision, no colours. @param {import("./shown_surface.js").ShownSurface} surface @returns {Promise<Uint8Array<ArrayBuffer>>} */
export async function toStl({ points, quads, place: { centre, diagonal } }) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setIndex(new BufferAttribute(trianglesOf(quads, points), 1));
  const mesh = new Mesh(geometry);
  mesh.scale.setScalar(diagonal);
  mesh.position.fromArray(centre);
  mesh.updateMatrixWorld();
  const { buffer } = new STLExporter().parse(mesh, { binary: true });
  return new Uint8Array(/** @type {ArrayBuffer} */ (buffer));
}
