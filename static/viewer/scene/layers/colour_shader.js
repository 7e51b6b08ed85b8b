import { CELL_TEXEL } from "../../geometry/texel.js";

/** GLSL: what colours the shown cells. */
export const COLOUR_INPUTS = `
uniform bool byCell;
uniform vec3 outsideColour;
uniform vec3 insideColour;
uniform vec3 missingColour;
uniform bool beyond;
uniform vec3 firstBeyond;
uniform vec3 lastBeyond;
uniform sampler2D cellValues;
uniform sampler2D palette;
uniform float paletteScale;
`;

/** GLSL: colour of a cell before light, by its value, or by whether filters expose the side that is seen. */
export const COLOUR_OF = `
${CELL_TEXEL}
vec3 colourOf(uint cell, float inside) {
  if (!byCell) return mix(outsideColour, insideColour, inside);
  float value = texelFetch(cellValues, cellTexel(cell), 0).r;
  int entry = int(clamp(value * paletteScale + 0.5, 0.0, 255.0));
  if (value < -1.0) return missingColour;
  if (beyond && value < 0.0) return firstBeyond;
  if (beyond && value > 1.0) return lastBeyond;
  return texelFetch(palette, ivec2(entry, 0), 0).rgb;
}
`;
