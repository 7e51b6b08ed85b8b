import {
  AddEquation,
  BufferAttribute,
  BufferGeometry,
  CustomBlending,
  DstAlphaFactor,
  GLSL3,
  Mesh,
  MinEquation,
  NormalBlending,
  OneFactor,
  OneMinusDstAlphaFactor,
  RawShaderMaterial,
  Vector4,
  ZeroFactor,
} from "three";

/**
 * How lines come to the picture: each over what is there; or in two rounds, by which each pixel of a network is blended once,
 * so that there are no dots where lines meet. The first leaves in the picture's alpha what the strongest line lets through
 * and keeps the colours; the second blends by that, and makes the pixel opaque again, so that it is not blended twice.
 *
 * A target without alpha, which the canvas is, can't: drafts are drawn on it.
 */
export const OVER = { blending: NormalBlending };

export const COVER = {
  blending: CustomBlending,
  blendEquation: AddEquation,
  blendSrc: ZeroFactor,
  blendDst: OneFactor,
  blendEquationAlpha: MinEquation,
  blendSrcAlpha: OneFactor,
  blendDstAlpha: OneFactor,
};

export const INK = {
  blending: CustomBlending,
  blendEquation: AddEquation,
  blendSrc: OneMinusDstAlphaFactor,
  blendDst: DstAlphaFactor,
  blendEquationAlpha: AddEquation,
  blendSrcAlpha: OneFactor,
  blendDstAlpha: ZeroFactor,
};

const VERTEX = `
precision highp float;
in vec2 position;
void main() { gl_Position = vec4(position, 0.0, 1.0); }
`;

const FRAGMENT = `
precision highp float;
uniform vec4 colour;
out vec4 pixel;
void main() { pixel = vec4(colour.rgb, 1.0); }
`;

/**
 * A triangle over the whole picture that does the second round for lines of one colour: faster than drawing many of them again.
 *
 * @returns {Mesh<BufferGeometry, RawShaderMaterial>}
 */
export function flood() {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 3, -1, -1, 3]), 2));
  const material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { colour: { value: new Vector4() } },
    transparent: true,
    depthTest: false,
    depthWrite: false,
    ...INK,
  });
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  return mesh;
}
