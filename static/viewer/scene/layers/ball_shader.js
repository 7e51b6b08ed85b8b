/** Shaders of points drawn as small balls, lit from the eye: of one size on the screen, whatever their distance. */

export const BALL_VERTEX = `
precision highp float;
in vec3 position;
in vec3 colour;
in float size;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform float pixelRatio;
uniform float pull;
out vec3 vColour;
out float vSize;
void main() {
  vColour = colour;
  vSize = size * pixelRatio;
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  // Nearer to the eye than its middle is, as the front of a ball.
  if (projectionMatrix[3][3] == 1.0) place.z += pull * vSize;
  else place.xyz *= 1.0 - pull * vSize;
  gl_Position = projectionMatrix * place;
  gl_PointSize = vSize + 1.0;
}
`;

export const BALL_FRAGMENT = `
precision highp float;
in vec3 vColour;
in float vSize;
uniform float opacity;
out vec4 pixel;
void main() {
  vec2 place = (gl_PointCoord * 2.0 - 1.0) * (vSize + 1.0) / vSize;
  float away = length(place);
  float cover = clamp((1.0 - away) * 0.5 * vSize + 0.5, 0.0, 1.0);
  if (cover == 0.0) discard;
  float facing = sqrt(max(0.0, 1.0 - away * away));
  vec2 light = place - vec2(-0.35, -0.4);
  float shine = 0.55 * pow(max(0.0, 1.0 - length(light)), 3.0);
  pixel = vec4(mix(vColour * mix(0.55, 1.0, facing), vec3(1.0), shine), cover * opacity);
}
`;
