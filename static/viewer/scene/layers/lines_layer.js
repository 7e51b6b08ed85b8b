import {
  BufferGeometry,
  DataTexture,
  DoubleSide,
  FloatType,
  GLSL3,
  Group,
  Mesh,
  RGFormat,
  RGIntegerFormat,
  RawShaderMaterial,
  RedIntegerFormat,
  UnsignedByteType,
  UnsignedIntType,
  Vector2,
  Vector3,
  Vector4,
} from "three";
import { componentsOf } from "../../colours/components.js";
import { COVER, INK, OVER, flood } from "./blending.js";
import { COLUMNS, LINES_FRAGMENT, LINES_VERTEX, STAGES } from "./lines_shader.js";
import { flatQuadIndex } from "../../geometry/quad_index.js";

/** Pixels, in the mean, below which lines that fade are fainter than they could be. */
const SHORT = 24;

/** Lines beyond which a triangle over the whole picture is drawn faster than they are once more. */
const MANY = 1000;

/** Of a row of the lines' texture: what is added to the style to shorten the line at its first end, and at its second. */
export const SHORTENED = [8, 16];

/** Added to a cell's number under a line: it is seen from a side that filters expose. */
export const INSIDE = 0x80000000;

/**
 * Line segments, each of one of at most eight styles (colour and ink).
 */
export class LinesLayer {
  group = new Group();
  /** Ribbon width in CSS pixels. */
  width = 1;
  /** Pixels that the lines stand nearer to the eye than they are: those on the surface, half their width and some. */
  pull = 1.5;
  #uniforms;
  #cover;
  #ink;
  #flood = flood();
  #count = 0;
  /** Mean length of a line. */
  #length = 0;
  #faintest = 1;
  #oneColour = true;
  /** Of a toned layer: whether any colour that lines may lie on is dark. */
  darkBelow = false;

  /**
   * @param {Style[]} styles
   * @typedef {{ colour: string, ink: number, width?: number }} Style  width: times that of the layer
   * @param {{ seeThrough?: boolean, fade?: boolean, toned?: import("./surface_layer.js").SurfaceLayer["uniforms"] | null }} [options]
   *   fade: thin out where segments are short on the screen; toned: light on dark, by what colours the surface that they lie on
   */
  constructor(styles, { seeThrough = false, fade = false, toned = null } = {}) {
    const none = /** @type {DataTexture | null} */ (null);
    this.#uniforms = {
      ends: { value: none },
      rows: { value: none },
      viewport: { value: new Vector2(1, 1) },
      width: { value: 1 },
      pull: { value: 0 },
      pixelSize: { value: 0 },
      fade: { value: fade ? 1 : 0 },
      opacity: { value: 1 },
      styles: { value: /** @type {Vector4[]} */ ([]) },
      widths: { value: new Float32Array(8) },
      under: { value: none },
      lightColour: { value: new Vector3(1, 1, 1) },
    };
    const material = (/** @type {Partial<RawShaderMaterial>} */ blending) =>
      new RawShaderMaterial({
        glslVersion: GLSL3,
        defines: toned ? { TONED: 1 } : {},
        vertexShader: LINES_VERTEX,
        fragmentShader: LINES_FRAGMENT,
        uniforms: { ...toned, ...this.#uniforms, stage: { value: STAGES.blend } },
        transparent: true,
        depthTest: !seeThrough,
        depthWrite: false,
        side: DoubleSide,
        forceSinglePass: true,
        ...blending,
      });
    const mesh = (/** @type {RawShaderMaterial} */ each) => {
      const made = new Mesh(new BufferGeometry(), each);
      made.frustumCulled = false;
      return made;
    };
    this.#cover = mesh(material(COVER));
    this.#cover.material.uniforms.stage.value = STAGES.cover;
    this.#ink = mesh(material({}));
    this.styles = styles;
    this.group.add(this.#cover, this.#ink, this.#flood);
    this.group.visible = false;
    this.#blendOnce(false);
  }

  /** @param {readonly Style[]} styles */
  set styles(styles) {
    const rows = Array.from({ length: 8 }, (_, k) => styles[Math.min(k, styles.length - 1)]);
    const uniforms = this.#uniforms;
    uniforms.styles.value = rows.map(({ colour, ink }) => new Vector4(...componentsOf(colour), ink));
    uniforms.widths.value = Float32Array.from(rows, ({ width = 1 }) => width);
    this.#faintest = Math.min(...styles.map(({ ink }) => ink));
    this.#oneColour = styles.every(({ colour }) => colour === styles[0].colour);
    this.#flood.material.uniforms.colour.value = uniforms.styles.value[0];
  }

  get count() {
    return this.#count;
  }

  /**
   * @param {Float32Array} ends (6N) end points
   * @param {Uint8Array | null} rows (N) row of the styles, plus what `SHORTENED` holds for ends to shorten; null: all the first
   * @param {Uint32Array | null} [under] (2N) of a toned layer: cells on both sides, plus `INSIDE`
   */
  set(ends, rows, under = null) {
    this.#release();
    this.#count = ends.length / 6;
    if (this.#count === 0) return;
    const height = Math.ceil(this.#count / COLUMNS);
    const uniforms = this.#uniforms;
    uniforms.ends.value = texture(new Float32Array(height * COLUMNS * 6), ends, 3 * COLUMNS, RGFormat);
    uniforms.rows.value = texture(new Uint8Array(height * COLUMNS), rows, COLUMNS, RedIntegerFormat);
    if (under)
      uniforms.under.value = texture(new Uint32Array(2 * height * COLUMNS), under, COLUMNS, RGIntegerFormat);
    const geometry = new BufferGeometry();
    geometry.setIndex(flatQuadIndex(this.#count));
    geometry.setDrawRange(0, 6 * this.#count);
    this.#cover.geometry = this.#ink.geometry = geometry;
    this.#length = meanLength(ends);
  }

  #release() {
    this.#ink.geometry.setIndex(null); // shared with the surface
    this.#ink.geometry.dispose();
    const { ends, rows, under } = this.#uniforms;
    for (const each of [ends, rows, under]) {
      each.value?.dispose();
      each.value = null;
    }
  }

  get opacity() {
    return this.#uniforms.opacity.value;
  }

  /** @param {number} opacity */
  set opacity(opacity) {
    this.#uniforms.opacity.value = opacity;
  }

  /**
   * @param {{ width: number, height: number, pixelRatio: number, pixel: number, draft?: boolean }} view size of the target in
   *   its pixels, and the size of a pixel: at the target for orthographic, at distance 1 for perspective
   */
  view({ width, height, pixelRatio, pixel, draft = false }) {
    const uniforms = this.#uniforms;
    uniforms.viewport.value.set(width, height);
    uniforms.width.value = Math.max(1, this.width * pixelRatio);
    uniforms.pull.value = pixel * this.pull * uniforms.width.value;
    uniforms.pixelSize.value = pixel;
    const fades = uniforms.fade.value > 0 && this.#length < SHORT * pixel;
    this.#blendOnce(!draft && (fades || this.opacity * this.#faintest < 1));
  }

  /** @param {boolean} once */
  #blendOnce(once) {
    this.#cover.visible = once;
    this.#flood.visible = once && this.#oneColour && !this.darkBelow && this.#count > MANY;
    this.#ink.visible = !this.#flood.visible;
    const { material } = this.#ink;
    material.uniforms.stage.value = once ? STAGES.ink : STAGES.blend;
    material.setValues(once ? INK : OVER);
  }

  dispose() {
    this.#release();
    this.#cover.material.dispose();
    this.#ink.material.dispose();
    this.#flood.geometry.dispose();
    this.#flood.material.dispose();
  }
}

/**
 * @param {Float32Array | Uint8Array | Uint32Array} whole as large as the texture, empty
 * @param {Float32Array | Uint8Array | Uint32Array | null} values
 * @param {number} columns
 * @param {import("three").PixelFormat} format
 */
function texture(whole, values, columns, format) {
  if (values && values.length <= whole.length) whole.set(values);
  const channels = format === RedIntegerFormat ? 1 : 2;
  const [type, internal] =
    whole instanceof Float32Array
      ? /** @type {const} */ ([FloatType, "RG32F"])
      : whole instanceof Uint32Array
        ? /** @type {const} */ ([UnsignedIntType, "RG32UI"])
        : /** @type {const} */ ([UnsignedByteType, "R8UI"]);
  const made = new DataTexture(whole, columns, whole.length / channels / columns, format, type);
  made.internalFormat = internal;
  made.needsUpdate = true;
  return made;
}

/** Mean length of some hundred lines, spread over all. @param {Float32Array} ends */
function meanLength(ends) {
  const count = ends.length / 6;
  const step = Math.max(1, Math.floor(count / 512));
  let [total, number] = [0, 0];
  for (let line = 0; line < count; line += step, number++) {
    const at = 6 * line;
    total += Math.hypot(ends[at + 3] - ends[at], ends[at + 4] - ends[at + 1], ends[at + 5] - ends[at + 2]);
  }
  return total / number;
}
