import { BufferAttribute } from "three";

let flatFaces = 0;
/** @type {BufferAttribute | null} */
let flatIndex = null;

/**
 * Triangle indices (a, b, c), (a, c, d) of faces whose vertices stand four by four. One array serves every surface: it only
 * grows, and a surface draws a prefix of it.
 *
 * @param {number} faces
 * @returns {BufferAttribute}
 */
export function flatQuadIndex(faces) {
  if (!flatIndex || faces > flatFaces) {
    flatFaces = Math.max(1024, Math.ceil(faces * 1.25));
    const index = new Uint32Array(6 * flatFaces);
    for (let face = 0, k = 0; face < flatFaces; face++) {
      const a = 4 * face;
      index[k++] = a;
      index[k++] = a + 1;
      index[k++] = a + 2;
      index[k++] = a;
      index[k++] = a + 2;
      index[k++] = a + 3;
    }
    flatIndex = new BufferAttribute(index, 1);
  }
  return flatIndex;
}

/**
 * Triangle indices of faces given by four vertices each.
 *
 * @param {Uint32Array} quads (4Q)
 * @returns {BufferAttribute}
 */
export function quadIndex(quads) {
  const index = new Uint32Array((quads.length / 4) * 6);
  for (let q = 0, k = 0; q < quads.length; q += 4) {
    index[k++] = quads[q];
    index[k++] = quads[q + 1];
    index[k++] = quads[q + 2];
    index[k++] = quads[q];
    index[k++] = quads[q + 2];
    index[k++] = quads[q + 3];
  }
  return new BufferAttribute(index, 1);
}
