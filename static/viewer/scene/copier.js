import {
  BufferAttribute,
  BufferGeometry,
  Camera,
  GLSL3,
  Mesh,
  NoBlending,
  RawShaderMaterial,
  Scene,
} from "three";

const VERTEX = `
in vec2 position;
void main() { gl_Position = vec4(position, 0.0, 1.0); }
`;

const FRAGMENT = `
precision highp float;
precision highp sampler2D;
uniform sampler2D source;
out vec4 pixel;
void main() { pixel = texelFetch(source, ivec2(gl_FragCoord.xy), 0); }
`;

/** Copies a texture onto the canvas, pixel by pixel. */
export class Copier {
  scene = new Scene();
  #camera = new Camera();
  #material = new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { source: { value: /** @type {import("three").Texture | null} */ (null) } },
    blending: NoBlending,
    depthTest: false,
    depthWrite: false,
  });

  constructor() {
    const triangle = new BufferGeometry();
    triangle.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 3, -1, -1, 3]), 2));
    const mesh = new Mesh(triangle, this.#material);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
    this.scene.matrixWorldAutoUpdate = false;
  }

  /** @param {import("three").WebGLRenderer} renderer @param {import("three").Texture} source */
  copy(renderer, source) {
    this.#material.uniforms.source.value = source;
    renderer.setRenderTarget(null);
    renderer.render(this.scene, this.#camera);
  }

  dispose() {
    /** @type {Mesh} */ (this.scene.children[0]).geometry.dispose();
    this.#material.dispose();
  }
}
