import { VERTEX_TEXEL } from "../../geometry/texel.js";
import { COLOUR_INPUTS, COLOUR_OF } from "./colour_shader.js";

/** GLSL: what the surface's vertices hold, and what colours them. */
export const SURFACE_INPUTS = `
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
${COLOUR_INPUTS}uniform usampler2D occlusion;
uniform float occlusionShare;
`;

/**
 * GLSL: a lamp at the eye. Lambert's cosine law over the original's emission of 0x30 of 255, so that a side seen edge on is as
 * dark as there, and one that faces the eye has the colour that was chosen.
 */
export const HEADLIGHT = `
float headlight(float facing) {
  return mix(0.19, 1.0, facing);
}
`;

/** GLSL: a vertex's colour before light, and how open it is to light. */
export const SURFACE_COLOUR = `
${COLOUR_OF}
${VERTEX_TEXEL}

float openness(int vertex) {
  uvec4 sums = texelFetch(occlusion, vertexTexel(vertex), 0);
  return sums.y == 0u ? 1.0 : min(1.0, float(max(sums.x, sums.z)) / float(sums.y));
}
`;

/**
 * The shown surface. Colour comes from the face's side or, by cell number, from the cell's value and the colour map. Light
 * multiplies it: nothing else touches a colour, so that a fully lit face has exactly the colour that was chosen.
 */
export const SURFACE_VERTEX = `
${SURFACE_INPUTS}uniform bool fourByFour;

out vec3 vColour;
out vec3 vNormal;
out vec3 vView;
out vec2 vPlace;
out float vOpen;
flat out vec4 vCorners;

${SURFACE_COLOUR}
void main() {
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * view;
  vView = projectionMatrix[3][3] == 1.0 ? vec3(0.0, 0.0, 1.0) : -view.xyz;
  vNormal = normalMatrix * normal.xyz;
  vColour = colourOf(cell, inside);
  vPlace = vec2(0.0);
  vCorners = vec4(1.0);
  vOpen = 1.0;
  if (occlusionShare > 0.0) {
    if (fourByFour) {
      int first = gl_VertexID & ~3;
      int corner = gl_VertexID & 3;
      vPlace = vec2(corner == 1 || corner == 2 ? 1.0 : 0.0, corner > 1 ? 1.0 : 0.0);
      vCorners = vec4(openness(first), openness(first + 1), openness(first + 2), openness(first + 3));
    } else {
      vOpen = openness(gl_VertexID);
    }
  }
}
`;

export const SURFACE_FRAGMENT = `
precision highp float;
precision highp sampler2D;

in vec3 vColour;
in vec3 vNormal;
in vec3 vView;
in vec2 vPlace;
in float vOpen;
flat in vec4 vCorners;
out vec4 pixel;

uniform int lighting;
uniform float shade;
uniform bool fourByFour;
uniform float occlusionShare;
uniform float screenShare;
uniform sampler2D screenOpenness;
uniform vec2 screenScale;
uniform vec2 screenOffset;

${HEADLIGHT}
// A face's four terms run bilinearly over it, not along the diagonal it happens to be cut at.
float faceOpenness() {
  if (!fourByFour) return vOpen;
  return mix(mix(vCorners.x, vCorners.y, vPlace.x), mix(vCorners.w, vCorners.z, vPlace.x), vPlace.y);
}

void main() {
  vec3 light = vec3(1.0);
  float facing = abs(dot(normalize(vNormal), normalize(vView)));
  if (lighting == 1) {
    light = vec3(headlight(facing));
  } else if (lighting >= 2) {
    float open = 1.0;
    if (screenShare > 0.0) {
      float screen = texture(screenOpenness, gl_FragCoord.xy * screenScale + screenOffset).r;
      open = mix(open, screen, screenShare);
    }
    if (occlusionShare > 0.0) open = mix(open, faceOpenness(), occlusionShare);
    light = vec3(open * mix(0.85, 1.0, facing));
  }
  pixel = vec4(vColour * mix(vec3(1.0), light, shade), 1.0);
}
`;
