import { BufferAttribute, BufferGeometry, GLSL3, Points, RawShaderMaterial } from "three";
import { componentsOf } from "../../colours/components.js";
import { BALL_FRAGMENT, BALL_VERTEX } from "./ball_shader.js";

/** @typedef {{ colour: string, size: number }} BallStyle  size: CSS pixels */

/** Of so many or fewer of a style each has its size; of more they are smaller, down to a share of it. */
const FEW = 60;
const SMALLEST = 0.22;

/** Points drawn as small balls. */
export class BallsLayer {
  points;
  #styles;

  /** @param {readonly BallStyle[]} styles */
  constructor(styles) {
    this.#styles = styles;
    const material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: BALL_VERTEX,
      fragmentShader: BALL_FRAGMENT,
      transparent: true,
      depthWrite: false,
      uniforms: { pixelRatio: { value: 1 }, pull: { value: 0 }, opacity: { value: 1 } },
    });
    this.points = new Points(new BufferGeometry(), material);
    this.points.frustumCulled = false;
    this.points.visible = false;
  }

  /** @param {Float32Array} positions @param {Uint8Array} rows of the styles */
  set(positions, rows) {
    this.points.geometry.dispose();
    const colours = new Uint8Array(3 * rows.length);
    const sizes = new Float32Array(rows.length);
    const styles = this.#styles.map(({ colour, size }, style) => ({
      size: size * crowding(rows.reduce((sum, row) => sum + Number(row === style), 0)),
      bytes: componentsOf(colour).map((part) => Math.round(255 * part)),
    }));
    rows.forEach((row, k) => {
      colours.set(styles[row].bytes, 3 * k);
      sizes[k] = styles[row].size;
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("colour", new BufferAttribute(colours, 3, true));
    geometry.setAttribute("size", new BufferAttribute(sizes, 1));
    this.points.geometry = geometry;
    this.points.visible = rows.length > 0;
  }

  /** @param {number} opacity */
  set opacity(opacity) {
    this.points.material.uniforms.opacity.value = opacity;
  }

  /** @param {{ pixelRatio: number, pixel: number }} view pixel: its size at the target for orthographic, at distance 1 for perspective */
  view({ pixelRatio, pixel }) {
    const { uniforms } = this.points.material;
    uniforms.pixelRatio.value = pixelRatio;
    uniforms.pull.value = 0.5 * pixel;
  }

  dispose() {
    this.points.geometry.dispose();
    this.points.material.dispose();
  }
}

/** Share of its size that each of so many has. @param {number} count */
function crowding(count) {
  return Math.min(1, Math.max(SMALLEST, Math.sqrt(FEW / Math.max(count, 1))));
}
