import { DataTexture, NearestFilter, RGIntegerFormat, UnsignedIntType } from "three";
import { VERTEX_COLUMNS, vertexRows, vertexTexel } from "../geometry/texel.js";

/** What openness is told in parts of. */
const WHOLE = 255;

/** @typedef {import("./lighting.js").LightingLike} LightingLike */

/**
 * Light that was gathered elsewhere: how open each vertex is to it comes with the surface.
 *
 * @example
 * light.openness = bytes; // before the surface it belongs to
 * @implements {LightingLike}
 */
export class BakedLight {
  /** @type {import("./lighting.js").LightingMode} */
  mode = "object_space_ao";
  /** @type {readonly import("three").Material[]} */
  materials = [];
  settled = true;
  elapsed = 0;
  /** Of each vertex of the surface, 0 to 255. */
  openness = /** @type {Uint8Array} */ (new Uint8Array(0));
  #layer;
  /** @type {DataTexture | null} */
  #texture = null;

  /** @param {import("./lighting.js").LitLayer} layer */
  constructor(layer) {
    this.#layer = layer;
  }

  restart() {
    this.forget();
  }

  forget() {
    this.#texture?.dispose();
    this.#texture = null;
  }

  step() {
    return { again: false, draw: false };
  }

  async complete() {}

  async baked() {
    return Float32Array.from(this.openness, (byte) => byte / WHOLE);
  }

  prepare() {
    const open = this.openness.length > 0;
    this.#layer.lighting = this.mode === "none" || open ? this.mode : "direct";
    this.#texture ??= open ? textureOf(this.openness) : null;
    this.#layer.setOcclusion(this.#texture ? 1 : 0, this.#texture);
    this.#layer.uniforms.screenShare.value = 0;
  }

  dispose() {
    this.forget();
  }
}

/** The sums that the surface's shader divides. @param {Uint8Array} openness */
function textureOf(openness) {
  const rows = vertexRows(openness.length);
  const sums = new Uint32Array(2 * VERTEX_COLUMNS * rows);
  openness.forEach((byte, vertex) => sums.set([byte, WHOLE], 2 * vertexTexel(vertex)));
  const texture = new DataTexture(sums, VERTEX_COLUMNS, rows, RGIntegerFormat, UnsignedIntType);
  texture.internalFormat = "RG32UI";
  texture.minFilter = texture.magFilter = NearestFilter;
  texture.needsUpdate = true;
  return texture;
}
