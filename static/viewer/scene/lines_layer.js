import {
  BufferAttribute,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  RawShaderMaterial,
  Vector2,
  Vector4,
} from "three";
import { componentsOf } from "./colour.js";
import { LINES_FRAGMENT, LINES_VERTEX } from "./lines_shader.js";

const RIBBON = new Float32Array([0, -1, 1, -1, 1, 1, 0, 1]);

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
   * @param {{ colour: string, ink: number }[]} styles
   * @param {{ seeThrough?: boolean, fade?: boolean }} [options] fade: thin out where segments are short on the screen
   */
  constructor(styles, { seeThrough = false, fade = false } = {}) {
    const rows = Array.from({ length: 8 }, (_, k) => styles[Math.min(k, styles.length - 1)]);
    this.#material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: LINES_VERTEX,
      fragmentShader: LINES_FRAGMENT,
      uniforms: {
        viewport: { value: new Vector2(1, 1) },
        width: { value: 1 },
        pull: { value: 0 },
        fade: { value: fade ? 1 : 0 },
        opacity: { value: 1 },
        styles: { value: rows.map(({ colour, ink }) => new Vector4(...componentsOf(colour), ink)) },
      },
      transparent: true,
      depthTest: !seeThrough,
      depthWrite: false,
      side: 2,
    });
    this.mesh = new Mesh(new InstancedBufferGeometry(), this.#material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  get count() {
    return this.#count;
  }

  /**
   * @param {Float32Array} ends (6N) end points
   * @param {Uint8Array | null} styles (N) row of the styles; null: all the first
   */
  set(ends, styles) {
    this.mesh.geometry.dispose();
    const geometry = new InstancedBufferGeometry();
    this.#count = ends.length / 6;
    const rows = styles && styles.length === this.#count ? styles : new Uint8Array(this.#count);
    const buffer = new InstancedInterleavedBuffer(ends, 6, 1);
    geometry.setIndex(new BufferAttribute(new Uint16Array([0, 1, 2, 0, 2, 3]), 1));
    geometry.setAttribute("corner", new BufferAttribute(RIBBON, 2));
    geometry.setAttribute("start", new InterleavedBufferAttribute(buffer, 3, 0));
    geometry.setAttribute("end", new InterleavedBufferAttribute(buffer, 3, 3));
    const style = new InstancedBufferAttribute(rows, 1);
    style.gpuType = 1013; // IntType: read as an integer by the shader
    geometry.setAttribute("style", style);
    geometry.instanceCount = this.#count;
    this.mesh.geometry = geometry;
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
    this.mesh.geometry.dispose();
    this.#material.dispose();
  }
}
