import {
  BackSide,
  BufferAttribute,
  FrontSide,
  GLSL3,
  Group,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Mesh,
  NoBlending,
  RawShaderMaterial,
  Vector3,
} from "three";
import { componentsOf } from "../../colours/components.js";
import { luminance } from "../../colours/luminance.js";
import { arrowShape } from "../../geometry/arrow_shape.js";
import { boxOf } from "../../geometry/box.js";
import { ARROWS_FRAGMENT, ARROWS_VERTEX } from "./arrows_shader.js";

const SIDES = 8;

/** CSS pixels that the rim of an arrow is broad: of light ink it is dark, of dark ink light, so that it stands out from any colour. */
const RIM = 1;
const LIGHT_RIM = "#ffffff";
const DARK_RIM = "#1d1f23";
const LIGHT = 0.3;

/** Part of the ink that a side lacks which is seen edge on. */
const SHADE = 0.5;

/**
 * Vectors on the shown surface as arrows, solid and tested against the model's depth.
 */
export class ArrowsLayer {
  group = new Group();
  #geometry = new InstancedBufferGeometry();
  #meshes;
  #uniforms = { reach: { value: 0.05 }, pixelSize: { value: 0 } };
  #wanted = false;
  /** Of their ends on the faces. @type {import("../../geometry/box.js").Box | null} */
  #faces = null;
  #count = 0;
  /** Whether the surface is newer, so that they would stand beside it. */
  stale = false;

  constructor() {
    const material = (/** @type {Partial<RawShaderMaterial>} */ how, /** @type {number} */ rim) =>
      new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader: ARROWS_VERTEX,
        fragmentShader: ARROWS_FRAGMENT,
        uniforms: {
          ...this.#uniforms,
          rim: { value: rim },
          shade: { value: rim ? 0 : SHADE },
          ink: { value: new Vector3() },
        },
        transparent: true, // to be drawn in its turn
        blending: NoBlending,
        ...how,
      });
    // Before the bodies the fronts of their rims, over the surface; after them the backs, over the arrows that lie behind.
    const materials = [
      material({ side: FrontSide, depthWrite: false }, RIM),
      material({ side: FrontSide }, 0),
      material({ side: BackSide }, RIM),
    ];
    this.#meshes = materials.map((each) => new Mesh(this.#geometry, each));
    for (const mesh of this.#meshes) mesh.frustumCulled = false;
    this.group.add(...this.#meshes);
    this.set(null);
  }

  /** @param {import("../../geometry/records.js").Arrows | null} arrows */
  set(arrows) {
    this.#geometry.dispose();
    this.#geometry = new InstancedBufferGeometry();
    this.#count = arrows ? arrows.inward.length : 0;
    this.#faces = arrows && boxOf(arrows.positions);
    this.stale = false;
    if (arrows && this.#count > 0) {
      const { rings, turns, index } = arrowShape(SIDES);
      const geometry = this.#geometry;
      geometry.setIndex(new BufferAttribute(index, 1));
      geometry.setAttribute("ring", new BufferAttribute(rings, 4));
      geometry.setAttribute("turn", new BufferAttribute(turns, 2));
      geometry.setAttribute("place", new InstancedBufferAttribute(arrows.positions, 3));
      geometry.setAttribute("vector", new InstancedBufferAttribute(arrows.vectors, 3));
      geometry.setAttribute("inward", new InstancedBufferAttribute(arrows.inward, 1));
      geometry.instanceCount = this.#count;
    }
    for (const mesh of this.#meshes) mesh.geometry = this.#geometry;
    this.#show();
  }

  /** @param {NonNullable<import("../types.js").SceneStatus["arrows"]>} wanted */
  look({ attribute, length, colour }) {
    if (attribute !== undefined) this.#wanted = attribute !== "";
    if (length !== undefined) this.#uniforms.reach.value = length;
    if (colour) {
      const ink = componentsOf(colour);
      const rim = componentsOf(luminance(ink) < LIGHT ? LIGHT_RIM : DARK_RIM);
      [rim, ink, rim].forEach((each, k) => this.#meshes[k].material.uniforms.ink.value.set(...each));
    }
    this.#show();
  }

  /** All arrows are within; null where none is drawn. @returns {import("../../geometry/box.js").Box | null} */
  get box() {
    if (!this.#faces || !this.#wanted) return null;
    const { low, high } = this.#faces;
    const reach = this.#uniforms.reach.value;
    return {
      low: [low[0] - reach, low[1] - reach, low[2] - reach],
      high: [high[0] + reach, high[1] + reach, high[2] + reach],
    };
  }

  #show() {
    this.group.visible = this.#wanted && this.#count > 0 && !this.stale;
  }

  /** @param {{ pixelRatio: number, pixel: number, draft?: boolean }} view as lines have it */
  view({ pixelRatio, pixel, draft = false }) {
    if (!draft) this.stale = false; // what a draft lacked has come, or had not changed
    this.#uniforms.pixelSize.value = pixel * Math.max(1, pixelRatio);
    for (const rim of [this.#meshes[0], this.#meshes[2]]) rim.visible = !draft;
    this.#show();
  }

  dispose() {
    this.#geometry.dispose();
    for (const mesh of this.#meshes) mesh.material.dispose();
  }
}
