import { CELL_TEXEL, VERTEX_TEXEL } from "./texel.js";

/**
 * The shown surface with its edges, for GPUs that are too slow for the whole picture while something moves: colour and light
 * come from the vertices alone, and an edge is what of a face lies within a pixel of its sides.
 */
export const DRAFT_VERTEX = `
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

in vec3 position;
in vec4 normal;
in uint cell;
in float inside;

uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat3 normalMatrix;
uniform int lighting;
uniform bool byCell;
uniform vec3 outsideColour;
uniform vec3 insideColour;
uniform vec3 missingColour;
uniform sampler2D cellValues;
uniform sampler2D palette;
uniform float paletteScale;
uniform usampler2D occlusion;
uniform float occlusionShare;

out vec3 vColour;
out vec3 vPlace;

${CELL_TEXEL}
${VERTEX_TEXEL}

void main() {
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * view;
  vec3 eye = projectionMatrix[3][3] == 1.0 ? vec3(0.0, 0.0, 1.0) : normalize(view.xyz);
  float facing = abs(dot(normalize(normalMatrix * normal.xyz), eye));
  float light = lighting == 1 ? mix(0.36, 1.0, pow(facing, 0.8)) : lighting == 0 ? 1.0 : mix(0.85, 1.0, facing);
  if (occlusionShare > 0.0) {
    uvec4 sums = texelFetch(occlusion, vertexTexel(gl_VertexID), 0);
    if (sums.y > 0u) light *= min(1.0, float(max(sums.x, sums.z)) / float(sums.y));
  }
  vec3 colour = mix(outsideColour, insideColour, inside);
  if (byCell) {
    float value = texelFetch(cellValues, cellTexel(cell), 0).r;
    int entry = int(clamp(value * paletteScale + 0.5, 0.0, 255.0));
    colour = value < 0.0 ? missingColour : texelFetch(palette, ivec2(entry, 0), 0).rgb;
  }
  vColour = colour * light;
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
