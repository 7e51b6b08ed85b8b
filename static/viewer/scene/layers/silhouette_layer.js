import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  EqualDepth,
  FrontSide,
  GLSL3,
  Group,
  Mesh,
  RawShaderMaterial,
  Vector4,
} from "three";
import { componentsOf } from "../../colours/components.js";
import { boxOf } from "../../geometry/box.js";
import { flatQuadIndex } from "../../geometry/quad_index.js";

const INPUTS = `
precision highp float;
in vec3 position;
in vec4 normal;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat3 normalMatrix;
`;

const VERTEX = `
${INPUTS}out vec3 vNormal;
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

const DRAFT_VERTEX = `
${INPUTS}uniform vec4 ink;
out vec4 vInk;
void main() {
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  vec3 eye = projectionMatrix[3][3] == 1.0 ? vec3(0.0, 0.0, 1.0) : normalize(view.xyz);
  float facing = abs(dot(normalize(normalMatrix * normal.xyz), eye));
  float clear = 1.0 - ink.a * (1.0 - pow(facing, 0.33));
  vInk = vec4(ink.rgb, 1.0 - clear * clear); // for the back side too
  gl_Position = projectionMatrix * view;
}
`;

const DRAFT_RIM = `
precision mediump float;
in vec4 vInk;
out vec4 pixel;
void main() { pixel = vInk; }
`;

/** Colours of the flat silhouette and of the shaded one, the original's. */
const FLAT_COLOUR = "#d7d7f0";
const RIM_COLOUR = "#d9d9f2";

/**
 * The pale shape of what is hidden. It belongs behind the model: painted first. All its layers have
 * one colour, so that blending them needs no order.
 */
export class SilhouetteLayer {
  group = new Group();
  /** @type {import("../../geometry/box.js").Box | null} */
  box = null;
  #geometry = new BufferGeometry();
  #meshes;
  #rims;
  #strength = 1;

  constructor() {
    const once = () => material(FLAT, FLAT_COLOUR);
    const cover = once();
    cover.colorWrite = false;
    cover.depthWrite = true;
    const flat = once();
    flat.depthFunc = EqualDepth;
    this.#rims = [material(RIM, RIM_COLOUR), material(DRAFT_RIM, RIM_COLOUR, DRAFT_VERTEX)];
    for (const rim of this.#rims) rim.depthTest = false;
    this.#rims[1].side = FrontSide;
    const rim = this.#rims[0];
    this.#meshes = [cover, flat, rim].map((each) => new Mesh(this.#geometry, each));
    // Behind the model means: before it, and leaving no depth.
    this.#meshes[1].onAfterRender = (renderer) => {
      renderer.state.buffers.depth.setMask(true);
      renderer.clearDepth();
    };
    for (const mesh of this.#meshes) {
      mesh.frustumCulled = false;
      this.group.add(mesh);
    }
    this.strength = 1;
    this.set(null);
  }

  /** @param {import("../../geometry/records.js").Silhouette | null} silhouette */
  set(silhouette) {
    this.#geometry.setIndex(null); // shared with the surface
    this.#geometry.dispose();
    this.#geometry = new BufferGeometry();
    const faces = silhouette ? silhouette.positions.length / 12 : 0;
    this.group.visible = faces > 0;
    this.box = silhouette && boxOf(silhouette.positions);
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
    for (const each of this.#rims) each.uniforms.ink.value.w = rim;
  }

  /** By which its rim is drawn: in a draft, or else. @param {boolean} draft */
  material(draft) {
    return this.#rims[draft ? 1 : 0];
  }

  /** @param {boolean} draft shaded from the vertices of the front alone */
  set draft(draft) {
    this.#meshes[2].material = this.material(draft);
  }

  dispose() {
    this.set(null);
    for (const mesh of this.#meshes) mesh.material.dispose();
    for (const rim of this.#rims) rim.dispose();
  }
}

/**
 * @param {string} fragmentShader
 * @param {string} colour
 * @param {string} [vertexShader]
 */
function material(fragmentShader, colour, vertexShader = VERTEX) {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    uniforms: { ink: { value: new Vector4(...componentsOf(colour), 1) } },
    transparent: true,
    depthWrite: false,
    side: DoubleSide,
    forceSinglePass: true,
  });
}
