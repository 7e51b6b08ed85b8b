/** Width of the textures that hold one value per cell. */
export const CELL_COLUMNS = 2048;

/** Width of the textures that hold one value per drawn vertex. */
export const VERTEX_COLUMNS = 2048;

/** GLSL: where the value of a cell stands. */
export const CELL_TEXEL = `
ivec2 cellTexel(uint cell) { return ivec2(int(cell & 2047u), int(cell >> 11)); }
`;

/**
 * GLSL: where the value of a drawn vertex stands. Four vertices that follow each other fill a block of 2 x 2 texels, so that
 * the corners of one flat face, which share a normal, run through the same branches on the GPU.
 */
export const VERTEX_TEXEL = `
ivec2 vertexTexel(int vertex) {
  int block = vertex >> 2;
  return ivec2(((block & 1023) << 1) | (vertex & 1), ((block >> 10) << 1) | ((vertex >> 1) & 1));
}
`;

/**
 * The same in JavaScript: index of a vertex's texel in row-major order.
 *
 * @param {number} vertex
 * @returns {number}
 */
export function vertexTexel(vertex) {
  const block = vertex >>> 2;
  const x = ((block & 1023) << 1) | (vertex & 1);
  const y = ((block >>> 10) << 1) | ((vertex >>> 1) & 1);
  return y * VERTEX_COLUMNS + x;
}

/**
 * Rows that a texture needs for so many drawn vertices.
 *
 * @param {number} vertices
 * @returns {number}
 */
export function vertexRows(vertices) {
  return 2 * Math.max(1, Math.ceil(vertices / (2 * VERTEX_COLUMNS)));
}
