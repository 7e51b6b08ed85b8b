import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  EqualDepth,
  GLSL3,
  Group,
  Mesh,
  RawShaderMaterial,
} from "three";
import { boxOf } from "../../geometry/box.js";
import { flatQuadIndex } from "../../geometry/quad_index.js";
import { COLOUR_OF } from "./colour_shader.js";
import { LinesLayer } from "./lines_layer.js";
import { HEADLIGHT, SURFACE_INPUTS } from "./surface_shader.js";
import { under } from "./under.js";

const VERTEX = `
${SURFACE_INPUTS}${COLOUR_OF}
out vec3 vColour;
out vec3 vNormal;
out vec3 vView;
invariant gl_Position;
void main() {
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  vView = projectionMatrix[3][3] == 1.0 ? vec3(0.0, 0.0, 1.0) : -view.xyz;
  vNormal = normalMatrix * normal.xyz;
  vColour = colourOf(cell, inside);
  gl_Position = projectionMatrix * view;
}
`;

const FRAGMENT = `
precision highp float;
in vec3 vColour;
in vec3 vNormal;
in vec3 vView;
out vec4 pixel;
uniform float opacity;
uniform float shade;
${HEADLIGHT}
void main() {
  float facing = abs(dot(normalize(vNormal), normalize(vView)));
  pixel = vec4(vColour * mix(1.0, headlight(facing), shade), opacity);
}
`;

const INK = [{ colour: "#000000", ink: 1 }];

/**
 * Hidden cells before the model, which is seen through them: of their faces the nearest, so that they are all as faint, and the
 * edges of these. Drawn last: it leaves its own depth.
 */
export class SeeThroughLayer {
  group = new Group();
  /** @type {import("../../geometry/box.js").Box | null} */
  box = null;
  #faces = 0;
  #geometry = new BufferGeometry();
  #meshes;
  #opacity = { value: 0.2 };
  #lines;

  /** @param {import("./surface_layer.js").SurfaceLayer["uniforms"]} uniforms of the surface: the same colours */
  constructor(uniforms) {
    const material = (/** @type {Partial<RawShaderMaterial>} */ how) =>
      new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader: VERTEX,
        fragmentShader: FRAGMENT,
        uniforms: { ...uniforms, opacity: this.#opacity },
        transparent: true,
        side: DoubleSide,
        forceSinglePass: true,
        polygonOffset: true,
        // Where a face lies on one that is shown, it is not before it.
        polygonOffsetFactor: 4,
        polygonOffsetUnits: 4,
        ...how,
      });
    const nearest = material({ colorWrite: false, depthWrite: true });
    const tint = material({ depthWrite: false, depthFunc: EqualDepth });
    this.#meshes = [nearest, tint].map((each) => new Mesh(this.#geometry, each));
    for (const mesh of this.#meshes) mesh.frustumCulled = false;
    this.#lines = new LinesLayer(INK, { fade: true, toned: uniforms });
    this.#lines.pull = 0;
    this.group.add(...this.#meshes, this.#lines.group);
    this.set(null);
  }

  /** @param {import("../../geometry/records.js").Surface | null} surface four by four, with its lines */
  set(surface) {
    this.#geometry.setIndex(null); // shared with the surface
    this.#geometry.dispose();
    this.#geometry = new BufferGeometry();
    this.#faces = surface?.faces.length ?? 0;
    this.box = surface && boxOf(surface.positions);
    if (surface && this.#faces > 0) {
      this.#geometry.setAttribute("position", new BufferAttribute(surface.positions, 3));
      this.#geometry.setAttribute("normal", new BufferAttribute(surface.normals, 4, true));
      this.#geometry.setAttribute("cell", new BufferAttribute(surface.cells, 1));
      this.#geometry.setAttribute("inside", new BufferAttribute(surface.inside, 1, true));
      this.#geometry.setIndex(flatQuadIndex(this.#faces));
      this.#geometry.setDrawRange(0, 6 * this.#faces);
    }
    for (const mesh of this.#meshes) mesh.geometry = this.#geometry;
    this.#lines.set(surface?.edges ?? new Float32Array(0), null, surface && under(surface));
    this.#show();
  }

  /** @param {NonNullable<import("../types.js").SceneStatus["see_through"]>} wanted */
  look({ opacity = this.#opacity.value }) {
    this.#opacity.value = this.#lines.opacity = opacity;
    this.#show();
  }

  #show() {
    this.group.visible = this.#opacity.value > 0 && this.#faces > 0;
    this.#lines.group.visible = this.#lines.count > 0;
  }

  /** @param {boolean} dark whether any colour that lines may lie on is dark */
  set darkBelow(dark) {
    this.#lines.darkBelow = dark;
  }

  /** @param {number} width of lines */
  set lineWidth(width) {
    this.#lines.width = width;
  }

  /** @param {Parameters<LinesLayer["view"]>[0]} view */
  view(view) {
    this.#lines.view(view);
  }

  dispose() {
    this.set(null);
    this.#lines.dispose();
    for (const mesh of this.#meshes) mesh.material.dispose();
  }
}
