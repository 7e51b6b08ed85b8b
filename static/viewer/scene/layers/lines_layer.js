import {
  BufferGeometry,
  DataTexture,
  DoubleSide,
  FloatType,
  GLSL3,
  Mesh,
  RGFormat,
  RawShaderMaterial,
  RedIntegerFormat,
  UnsignedByteType,
  Vector2,
  Vector4,
} from "three";
import { componentsOf } from "../../colours/components.js";
import { COLUMNS, LINES_FRAGMENT, LINES_VERTEX } from "./lines_shader.js";
import { flatQuadIndex } from "../../geometry/quad_index.js";

/**
 * Line segments, each of one of at most eight styles (colour and ink).
 */
export class LinesLayer {
  mesh;
  /** Ribbon width in CSS pixels. */
  width = 1;
  /** Pixels that the lines stand nearer to the eye than they are: those on the surface, half their width and some. */
  pull = 1.5;
  #material;
  #count = 0;

  /**
   * @param {Style[]} styles
   * @typedef {{ colour: string, ink: number, width?: number }} Style  width: times that of the layer
   * @param {{ seeThrough?: boolean, fade?: boolean }} [options] fade: thin out where segments are short on the screen
   */
  constructor(styles, { seeThrough = false, fade = false } = {}) {
    this.#material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: LINES_VERTEX,
      fragmentShader: LINES_FRAGMENT,
      uniforms: {
        ends: { value: /** @type {DataTexture | null} */ (null) },
        rows: { value: /** @type {DataTexture | null} */ (null) },
        viewport: { value: new Vector2(1, 1) },
        width: { value: 1 },
        pull: { value: 0 },
        fade: { value: fade ? 1 : 0 },
        opacity: { value: 1 },
        styles: { value: /** @type {Vector4[]} */ ([]) },
        widths: { value: new Float32Array(8) },
      },
      transparent: true,
      depthTest: !seeThrough,
      depthWrite: false,
      side: DoubleSide,
      forceSinglePass: true,
    });
    this.styles = styles;
    this.mesh = new Mesh(new BufferGeometry(), this.#material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  /** @param {readonly Style[]} styles */
  set styles(styles) {
    const rows = Array.from({ length: 8 }, (_, k) => styles[Math.min(k, styles.length - 1)]);
    const { uniforms } = this.#material;
    uniforms.styles.value = rows.map(({ colour, ink }) => new Vector4(...componentsOf(colour), ink));
    uniforms.widths.value = Float32Array.from(rows, ({ width = 1 }) => width);
  }

  get count() {
    return this.#count;
  }

  /**
   * @param {Float32Array} ends (6N) end points
   * @param {Uint8Array | null} styles (N) row of the styles; null: all the first
   */
  set(ends, styles) {
    this.#release();
    this.#count = ends.length / 6;
    if (this.#count === 0) return;
    const height = Math.ceil(this.#count / COLUMNS);
    const whole = new Float32Array(height * COLUMNS * 6);
    whole.set(ends);
    const rows = new Uint8Array(height * COLUMNS);
    if (styles && styles.length === this.#count) rows.set(styles);
    const { uniforms } = this.#material;
    uniforms.ends.value = new DataTexture(whole, 3 * COLUMNS, height, RGFormat, FloatType);
    uniforms.rows.value = new DataTexture(rows, COLUMNS, height, RedIntegerFormat, UnsignedByteType);
    uniforms.rows.value.internalFormat = "R8UI";
    uniforms.ends.value.needsUpdate = uniforms.rows.value.needsUpdate = true;
    const geometry = new BufferGeometry();
    geometry.setIndex(flatQuadIndex(this.#count));
    geometry.setDrawRange(0, 6 * this.#count);
    this.mesh.geometry = geometry;
  }

  #release() {
    this.mesh.geometry.setIndex(null); // shared with the surface
    this.mesh.geometry.dispose();
    const { ends, rows } = this.#material.uniforms;
    ends.value?.dispose();
    rows.value?.dispose();
    ends.value = rows.value = null;
  }

  get opacity() {
    return this.#material.uniforms.opacity.value;
  }

  /** @param {number} opacity */
  set opacity(opacity) {
    this.#material.uniforms.opacity.value = opacity;
  }

  /**
   * @param {{ width: number, height: number, pixelRatio: number, pixel: number }} view size of the target in its pixels, and
   *   the size of a pixel: at the target for orthographic, at distance 1 for perspective
   */
  view({ width, height, pixelRatio, pixel }) {
    const uniforms = this.#material.uniforms;
    uniforms.viewport.value.set(width, height);
    uniforms.width.value = Math.max(1, this.width * pixelRatio);
    uniforms.pull.value = pixel * this.pull * uniforms.width.value;
  }

  dispose() {
    this.#release();
    this.#material.dispose();
  }
}
