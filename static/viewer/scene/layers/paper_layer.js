import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh, RawShaderMaterial } from "three";
import { componentsOf } from "../../colours/components.js";
import { flatQuadIndex } from "../../geometry/quad_index.js";
import { VALENCE_STYLES } from "../../colours/valence.js";
import { FILM_FRAGMENT, FILM_VERTEX } from "./film_shader.js";

/**
 * Flaps of paper glued to irregular edges: unlit, seen from both sides, dark at the edge and bright at the rim.
 */
export class PaperLayer {
  mesh;
  count = 0;
  /** @type {keyof typeof VALENCE_STYLES} */
  palette = "standard";
  #material;

  /** @param {{ seeThrough: boolean }} options */
  constructor({ seeThrough }) {
    this.#material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: FILM_VERTEX,
      fragmentShader: FILM_FRAGMENT,
      uniforms: { opacity: { value: 1 } },
      transparent: true,
      depthTest: !seeThrough,
      depthWrite: !seeThrough,
      side: DoubleSide,
      forceSinglePass: true,
    });
    this.mesh = new Mesh(new BufferGeometry(), this.#material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  /**
   * @param {Float32Array} corners (12P) the first two corners of each flap lie on the edge
   * @param {Uint8Array} styles (P) row of the valence styles
   */
  set(corners, styles) {
    const old = this.mesh.geometry;
    old.setIndex(null); // shared with the surface
    old.dispose();
    this.count = styles.length;
    const colours = new Uint8Array(12 * this.count);
    const inks = VALENCE_STYLES[this.palette].map(({ inner, rim }) =>
      [inner, inner, rim, rim].flatMap(componentsOf).map((c) => Math.round(255 * c)),
    );
    styles.forEach((style, k) => colours.set(inks[style], 12 * k));
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(corners, 3));
    geometry.setAttribute("colour", new BufferAttribute(colours, 3, true));
    geometry.setIndex(flatQuadIndex(this.count));
    geometry.setDrawRange(0, 6 * this.count);
    this.mesh.geometry = geometry;
  }

  /** @param {number} opacity */
  set opacity(opacity) {
    this.#material.uniforms.opacity.value = opacity;
  }

  dispose() {
    this.mesh.geometry.setIndex(null);
    this.mesh.geometry.dispose();
    this.#material.dispose();
  }
}
