import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  EqualDepth,
  GLSL3,
  Group,
  Mesh,
  RawShaderMaterial,
  Vector4,
} from "three";
import { componentsOf } from "./colour.js";
import { flatQuadIndex } from "./quad_index.js";

const VERTEX = `
precision highp float;
in vec3 position;
in vec4 normal;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat3 normalMatrix;
out vec3 vNormal;
out vec3 vView;
invariant gl_Position;
void main() {
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  vView = projectionMatrix[3][3] == 1.0 ? vec3(0.0, 0.0, 1.0) : -view.xyz;
  vNormal = normalMatrix * normal.xyz;
  gl_Position = projectionMatrix * view;
}
`;

const FLAT = `
precision highp float;
uniform vec4 ink;
out vec4 pixel;
void main() { pixel = ink; }
`;

const RIM = `
precision highp float;
in vec3 vNormal;
in vec3 vView;
uniform vec4 ink;
out vec4 pixel;
void main() {
  float facing = abs(dot(normalize(vNormal), normalize(vView)));
  pixel = vec4(ink.rgb, ink.a * (1.0 - pow(facing, 0.33)));
}
`;

/** Colours of the flat silhouette and of the shaded one, the original's. */
const FLAT_COLOUR = "#d7d7f0";
const RIM_COLOUR = "#d9d9f2";

/**
 * The pale shape of what is hidden. It belongs behind the model: painted first, then depth is cleared. All its layers have
 * one colour, so that blending them needs no order.
 */
export class SilhouetteLayer {
  group = new Group();
  #geometry = new BufferGeometry();
  #meshes;
  #strength = 1;

  constructor() {
    const once = () => material(FLAT, FLAT_COLOUR);
    const cover = once();
    cover.colorWrite = false;
    cover.depthWrite = true;
    const flat = once();
    flat.depthFunc = EqualDepth;
    const rim = material(RIM, RIM_COLOUR);
    rim.depthTest = false;
    this.#meshes = [cover, flat, rim].map((each) => new Mesh(this.#geometry, each));
    for (const mesh of this.#meshes) {
      mesh.frustumCulled = false;
      this.group.add(mesh);
    }
    this.strength = 1;
    this.set(null);
  }

  /** @param {import("./types.js").Silhouette | null} silhouette */
  set(silhouette) {
    this.#geometry.setIndex(null); // shared with the surface
    this.#geometry.dispose();
    this.#geometry = new BufferGeometry();
    const faces = silhouette ? silhouette.positions.length / 12 : 0;
    this.group.visible = faces > 0;
    if (silhouette && faces > 0) {
      this.#geometry.setAttribute("position", new BufferAttribute(silhouette.positions, 3));
      this.#geometry.setAttribute("normal", new BufferAttribute(silhouette.normals, 4, true));
      this.#geometry.setIndex(flatQuadIndex(faces));
      this.#geometry.setDrawRange(0, 6 * faces);
    }
    for (const mesh of this.#meshes) mesh.geometry = this.#geometry;
  }

  /** 0 none, 0.5 flat, 1 shaded; in between they fade. @param {number} strength */
  set strength(strength) {
    this.#strength = Math.min(1, Math.max(0, strength));
    const rim = Math.max(0, 2 * this.#strength - 1);
    const flat = this.#strength < 0.5 ? 2 * this.#strength : 2 - 2 * this.#strength;
    const [cover, even, shaded] = this.#meshes;
    cover.visible = even.visible = flat > 0;
    shaded.visible = rim > 0;
    even.material.uniforms.ink.value.w = flat;
    shaded.material.uniforms.ink.value.w = rim;
  }

  dispose() {
    this.set(null);
    for (const mesh of this.#meshes) mesh.material.dispose();
  }
}

/**
 * @param {string} fragmentShader
 * @param {string} colour
 */
function material(fragmentShader, colour) {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader,
    uniforms: { ink: { value: new Vector4(...componentsOf(colour), 1) } },
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    forceSinglePass: true,
  });
}
