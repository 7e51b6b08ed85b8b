/** Shaders of flat faces, each with colours of its own: unlit, as translucent as the layer. */

export const FILM_VERTEX = `
precision highp float;
in vec3 position;
in vec3 colour;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
out vec3 vColour;
void main() {
  vColour = colour;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`;

export const FILM_FRAGMENT = `
precision highp float;
in vec3 vColour;
uniform float opacity;
out vec4 pixel;
void main() { pixel = vec4(vColour, opacity); }
`;
