import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh, RawShaderMaterial, Vector4 } from "three";
import { componentsOf } from "../../colours/components.js";

const VERTEX = `
precision highp float;
in vec3 position;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }
`;

const FRAGMENT = `
precision highp float;
uniform vec4 ink;
out vec4 pixel;
void main() { pixel = ink; }
`;

/**
 * A few triangles of one translucent colour: the plane, the face under the pointer.
 */
export class FlatLayer {
  mesh;
  #material;

  /** @param {string} colour @param {number} opacity @param {{ raised?: boolean }} [options] raised: lies on the surface */
  constructor(colour, opacity, { raised = false } = {}) {
    this.#material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { ink: { value: new Vector4(...componentsOf(colour), opacity) } },
      transparent: true,
      depthWrite: false,
      side: DoubleSide,
      forceSinglePass: true,
      polygonOffset: raised,
      polygonOffsetFactor: -1,
      polygonOffsetUnits: -4,
    });
    this.mesh = new Mesh(new BufferGeometry(), this.#material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  /** @param {Float32Array} corners three per triangle */
  set(corners) {
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    this.mesh.geometry.setAttribute("position", new BufferAttribute(corners, 3));
    this.mesh.visible = corners.length > 0;
  }

  dispose() {
    this.mesh.geometry.dispose();
    this.#material.dispose();
  }
}
