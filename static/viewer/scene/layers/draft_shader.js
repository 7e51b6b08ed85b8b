import { HEADLIGHT, SURFACE_COLOUR, SURFACE_INPUTS } from "./surface_shader.js";

/**
 * The shown surface with its edges, for GPUs that are too slow for the whole picture while something moves: colour and light
 * come from the vertices alone, and an edge is what of a face lies within a pixel of its sides.
 */
export const DRAFT_VERTEX = `
${SURFACE_INPUTS}
uniform int lighting;
uniform float shade;

out vec3 vColour;
out vec3 vPlace;

${HEADLIGHT}
${SURFACE_COLOUR}
void main() {
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * view;
  vec3 eye = projectionMatrix[3][3] == 1.0 ? vec3(0.0, 0.0, 1.0) : normalize(view.xyz);
  float facing = abs(dot(normalize(normalMatrix * normal.xyz), eye));
  float light = lighting == 1 ? headlight(facing) : lighting == 0 ? 1.0 : mix(0.85, 1.0, facing);
  if (occlusionShare > 0.0) light *= openness(gl_VertexID);
  vColour = colourOf(cell, inside) * mix(1.0, light, shade);
  // The third side of a triangle a b c c is the diagonal of its square; the square itself has none to draw.
  int corner = gl_VertexID & 3;
  vec2 place = vec2(corner == 1 || corner == 2 ? 1.0 : 0.0, corner > 1 ? 1.0 : 0.0);
  vPlace = vec3(place, normal.w > 0.0 ? place.x - place.y : 2.0 + place.x - place.y);
}
`;

export const DRAFT_FRAGMENT = `
precision highp float;
in vec3 vColour;
in vec3 vPlace;
out vec4 pixel;
uniform float edgeInk;
void main() {
  float ink = 0.0;
  if (edgeInk > 0.0) {
    vec3 sides = vec3(min(vPlace.xy, 1.0 - vPlace.xy), vPlace.z) / max(fwidth(vPlace), 1e-6);
    ink = edgeInk * clamp(1.0 - min(min(sides.x, sides.y), sides.z), 0.0, 1.0);
  }
  pixel = vec4(vColour * (1.0 - ink), 1.0);
}
`;
