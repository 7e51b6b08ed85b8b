import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  EqualDepth,
  GLSL3,
  Group,
  Mesh,
  RawShaderMaterial,
} from "three";
import { boxOf } from "../../geometry/box.js";
import { flatQuadIndex } from "../../geometry/quad_index.js";
import { HEADLIGHT } from "./surface_shader.js";

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

const FRAGMENT = `
precision highp float;
in vec3 vNormal;
in vec3 vView;
uniform vec3 ink;
uniform float opacity;
out vec4 pixel;
${HEADLIGHT}
void main() {
  float facing = abs(dot(normalize(vNormal), normalize(vView)));
  // A film looks denser where it is seen aslant: so its shape shows, however faint it is.
  pixel = vec4(ink * headlight(facing), mix(min(1.0, 2.0 * opacity), opacity, facing));
}
`;

/** The surface of what the mesh is compared with, as a film over the model; of its faces the nearest alone. */
export class ReferenceLayer {
  group = new Group();
  /** @type {import("../../geometry/box.js").Box | null} */
  box = null;
  #faces = 0;
  #geometry = new BufferGeometry();
  #meshes;
  #uniforms = { ink: { value: new Color() }, opacity: { value: 0.3 } };

  constructor() {
    const material = (/** @type {Partial<RawShaderMaterial>} */ how) =>
      new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader: VERTEX,
        fragmentShader: FRAGMENT,
        uniforms: this.#uniforms,
        transparent: true,
        side: DoubleSide,
        forceSinglePass: true,
        // Where it lies on the model it is not before it.
        polygonOffset: true,
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 1,
        ...how,
      });
    const nearest = material({ colorWrite: false, depthWrite: true });
    const tint = material({ depthWrite: false, depthFunc: EqualDepth });
    this.#meshes = [nearest, tint].map((each) => new Mesh(this.#geometry, each));
    for (const mesh of this.#meshes) mesh.frustumCulled = false;
    this.group.add(...this.#meshes);
    this.set(null);
  }

  /** @param {import("../../geometry/records.js").Silhouette | null} surface four by four */
  set(surface) {
    this.#geometry.setIndex(null); // shared with the surface
    this.#geometry.dispose();
    this.#geometry = new BufferGeometry();
    this.#faces = surface ? surface.positions.length / 12 : 0;
    this.box = surface && this.#faces ? boxOf(surface.positions) : null;
    if (surface && this.#faces > 0) {
      this.#geometry.setAttribute("position", new BufferAttribute(surface.positions, 3));
      this.#geometry.setAttribute("normal", new BufferAttribute(surface.normals, 4, true));
      this.#geometry.setIndex(flatQuadIndex(this.#faces));
      this.#geometry.setDrawRange(0, 6 * this.#faces);
    }
    for (const mesh of this.#meshes) mesh.geometry = this.#geometry;
    this.#show();
  }

  /** @param {NonNullable<NonNullable<import("../types.js").SceneStatus["compare"]>["reference"]>} wanted */
  look({ opacity, colour }) {
    if (opacity !== undefined) this.#uniforms.opacity.value = opacity;
    if (colour !== undefined) this.#uniforms.ink.value.set(colour);
    this.#show();
  }

  #show() {
    this.group.visible = this.#uniforms.opacity.value > 0 && this.#faces > 0;
  }

  dispose() {
    this.set(null);
    for (const mesh of this.#meshes) mesh.material.dispose();
  }
}
