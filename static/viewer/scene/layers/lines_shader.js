import { DARK } from "../../colours/luminance.js";
import { COLOUR_INPUTS, COLOUR_OF } from "./colour_shader.js";

/** Lines in a row of the textures that hold them. */
export const COLUMNS = 680;

/** Ink of light lines, of what dark ones have: light strikes more on dark than dark on what is as far from it. */
const LIGHT_INK = "0.65";

/** What of a line is drawn: see `blending.js`. */
export const STAGES = { blend: 0, cover: 1, ink: 2 };

/** Share of the ink that edges so many pixels long keep: all of it would blacken a fine mesh. @param {number} length @returns {number} */
export function fading(length) {
  return Math.min(1, Math.max(0.25, (length + 1.5) / 8));
}

/**
 * Line segments as ribbons of constant width on the screen: at least a pixel, smooth at the rim, pulled towards the eye by
 * the depth that half their width may cover, so that they do not fight with the surface they lie on. Their ends are fetched
 * from a texture, three texels of two numbers each: drawing each line as an instance is far slower on software GPUs.
 *
 * A line's row holds its style in three bits, and two that shorten its first and its second end, which lie on the body's
 * boundary and would show there as dots. With TONED, lines are light where all that lies under them is dark.
 */
export const LINES_VERTEX = `
#define COLUMNS ${COLUMNS}
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

uniform sampler2D ends;
uniform usampler2D rows;

uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform vec2 viewport;
uniform float width;
uniform float pull;
uniform float fade;
uniform float pixelSize;
uniform vec4 styles[8];
uniform float widths[8];
#ifdef TONED
uniform usampler2D under;
uniform vec3 lightColour;
${COLOUR_INPUTS}
${COLOUR_OF}
const uint INSIDE = 0x80000000u;

float luminanceOf(uint side) {
  vec3 colour = colourOf(side & ~INSIDE, (side & INSIDE) != 0u ? 1.0 : 0.0);
  return dot(pow(colour, vec3(2.2)), vec3(0.2126, 0.7152, 0.0722));
}
#endif

out float vAcross;
flat out vec4 vStyle;
flat out float vWidth;

/** From an end on the boundary so far inward that what is left of the line does not touch the surface there. */
vec3 inward(vec3 end, vec3 other, float pixels) {
  float depth = -(modelViewMatrix * vec4(end, 1.0)).z;
  float unit = projectionMatrix[3][3] == 1.0 ? pixelSize : pixelSize * max(depth, 0.0);
  vec3 way = other - end;
  return end + way * min(0.4, pixels * unit / max(length(way), 1e-9));
}

vec4 towardsEye(vec3 place) {
  vec4 view = modelViewMatrix * vec4(place, 1.0);
  if (projectionMatrix[3][3] == 1.0) view.z += pull;
  else view.xyz *= 1.0 - pull;
  return projectionMatrix * view;
}

void main() {
  int line = gl_VertexID >> 2;
  vec2 corner = vec2((gl_VertexID + 1 & 2) >> 1, (gl_VertexID & 2) - 1);
  ivec2 at = ivec2(line % COLUMNS, line / COLUMNS);
  vec2 xy = texelFetch(ends, ivec2(3 * at.x, at.y), 0).xy;
  vec2 zx = texelFetch(ends, ivec2(3 * at.x + 1, at.y), 0).xy;
  vec2 yz = texelFetch(ends, ivec2(3 * at.x + 2, at.y), 0).xy;
  vec3 start = vec3(xy, zx.x);
  vec3 end = vec3(zx.y, yz);
  uint row = texelFetch(rows, at, 0).r;
  uint style = row & 7u;
  vWidth = max(1.0, width * widths[style]);
  vec3 first = start;
  if ((row & 8u) != 0u) start = inward(start, end, 0.5 * vWidth + 1.5);
  if ((row & 16u) != 0u) end = inward(end, first, 0.5 * vWidth + 1.5);
  vec4 a = towardsEye(start);
  vec4 b = towardsEye(end);
  float da = a.z + a.w;
  float db = b.z + b.w;
  if (da < 0.0 && db < 0.0) {
    gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    return;
  }
  if (da < 0.0) a = mix(a, b, (1e-6 - da) / (db - da));
  else if (db < 0.0) b = mix(b, a, (1e-6 - db) / (da - db));
  vec3 pa = a.xyz / a.w;
  vec3 pb = b.xyz / b.w;
  vec2 along = (pb.xy - pa.xy) * 0.5 * viewport;
  float length = length(along);
  vec2 across = length > 1e-4 ? vec2(-along.y, along.x) / length : vec2(0.0, 1.0);
  float reach = 0.5 * vWidth + 0.5;
  vec3 place = corner.x < 0.5 ? pa : pb;
  place.xy += across * corner.y * reach * 2.0 / viewport;
  vAcross = corner.y * reach;
  vStyle = styles[style];
#ifdef TONED
  uvec2 sides = texelFetch(under, at, 0).rg;
  if (max(luminanceOf(sides.x), luminanceOf(sides.y)) < ${DARK}) vStyle = vec4(lightColour, ${LIGHT_INK} * vStyle.a);
#endif
  // As fading() has it, below 1 by the length of each.
  vStyle.a *= mix(1.0, clamp((length + 1.5) / 8.0, 0.25, 1.0), fade);
  gl_Position = vec4(place, 1.0);
}
`;

export const LINES_FRAGMENT = `
precision highp float;

in float vAcross;
flat in vec4 vStyle;
flat in float vWidth;
out vec4 pixel;

uniform float opacity;
uniform int stage;

void main() {
  float cover = vStyle.a * opacity * clamp(0.5 * vWidth + 0.5 - abs(vAcross), 0.0, 1.0);
  if (stage == ${STAGES.blend}) pixel = vec4(vStyle.rgb, cover);
  else if (stage == ${STAGES.cover}) pixel = vec4(0.0, 0.0, 0.0, 1.0 - cover);
  else pixel = vec4(vStyle.rgb, 1.0);
}
`;
