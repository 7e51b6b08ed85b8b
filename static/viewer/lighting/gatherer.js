import {
  BufferAttribute,
  BufferGeometry,
  Camera,
  DataTexture,
  GLSL3,
  Mesh,
  NearestFilter,
  RGBAIntegerFormat,
  RawShaderMaterial,
  Scene,
  UnsignedIntType,
  Vector4,
  WebGLRenderTarget,
} from "three";
import { VERTEX_COLUMNS } from "../geometry/texel.js";
import { TILES } from "./depth_atlas.js";
import { GROOVE_SHARES } from "./plates.js";

/** Directions after which a vertex whose back sees more light than its front is turned round for good. */
export const TURNING = 32;

const VERTEX = `
in vec2 position;
void main() { gl_Position = vec4(position, 0.0, 1.0); }
`;

const FRAGMENT = `
precision highp float;
precision highp int;
precision highp sampler2DShadow;
precision highp usampler2D;

uniform usampler2D points;
uniform usampler2D before;
uniform sampler2DShadow atlas;
uniform vec4 rowX[${TILES}];
uniform vec4 rowY[${TILES}];
uniform vec4 rowZ[${TILES}];
uniform vec4 towards[${TILES}];
uniform int first;
uniform int count;
uniform float lift;
out uvec4 sums;

const float UNIT = 65536.0;
const float SHARES[4] = float[4](${GROOVE_SHARES.map((share) => share.toFixed(3)).join(", ")});

vec3 unpackNormal(uint word) {
  vec2 e = unpackSnorm2x16(word);
  vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
  if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
  return normalize(n);
}

float seen(int k, vec3 place) {
  vec4 p = vec4(place, 1.0);
  vec3 at = vec3(dot(rowX[k], p), dot(rowY[k], p), dot(rowZ[k], p)) * 0.5 + 0.5;
  return texture(atlas, at);
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  uvec4 point = texelFetch(points, texel, 0);
  float share = SHARES[point.w & 3u];
  if (share == 0.0) {
    sums = uvec4(0u, 1u, 0u, 0u);
    return;
  }
  vec3 place = uintBitsToFloat(point.xyz);
  vec3 normal = unpackNormal(point.w);
  sums = first == 0 ? uvec4(0u) : texelFetch(before, texel, 0);
  bool turned = first >= ${TURNING} && sums.z > sums.w;
  if (turned) {
    normal = -normal;
    if (first == ${TURNING}) sums.x = sums.z;
  }
  for (int k = 0; k < count; k++) {
    float cosine = dot(normal, towards[k].xyz);
    if (cosine > 0.0) {
      uint lit = uint(cosine * share * seen(k, place + lift * normal) * UNIT);
      sums.x += lit;
      sums.y += uint(cosine * UNIT);
      if (first < ${TURNING}) sums.w += lit;
    } else if (first < ${TURNING}) {
      sums.z += uint(-cosine * share * seen(k, place - lift * normal) * UNIT);
    }
  }
}
`;

/**
 * Adds up, for every gathering point, the light that reaches it by the cosine law: a texel per drawn vertex holds the light
 * that came (x) and the light that would have come with nothing in the way (y), and for the first directions that on the
 * back (z) and front (w), which tells an inverted face. Sums are whole numbers: the order of adding can't matter, and every
 * WebGL 2 can draw into them, with no blending.
 */
export class Gatherer {
  #scene = new Scene();
  #camera = new Camera();
  #material;
  /** @type {WebGLRenderTarget[]} */
  #targets = [];
  /** @type {DataTexture | null} */
  #points = null;
  #rows = 0;

  constructor() {
    this.#material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        points: { value: null },
        before: { value: null },
        atlas: { value: null },
        rowX: { value: null },
        rowY: { value: null },
        rowZ: { value: null },
        towards: { value: Array.from({ length: TILES }, () => new Vector4()) },
        first: { value: 0 },
        count: { value: 0 },
        lift: { value: 0 },
      },
      depthTest: false,
      depthWrite: false,
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 3, -1, -1, 3]), 2));
    const mesh = new Mesh(geometry, this.#material);
    mesh.frustumCulled = false;
    this.#scene.add(mesh);
    this.#scene.matrixWorldAutoUpdate = false;
  }

  /** By which it is drawn. */
  get material() {
    return this.#material;
  }

  /** The sums so far. @returns {import("three").Texture} */
  get texture() {
    return this.#targets[0].texture;
  }

  /**
   * @param {import("three").WebGLRenderer} renderer
   * @param {{ words: Uint32Array, rows: number }} points
   */
  setPoints(renderer, { words, rows }) {
    this.#points?.dispose();
    this.#points = new DataTexture(words, VERTEX_COLUMNS, rows, RGBAIntegerFormat, UnsignedIntType);
    this.#points.internalFormat = "RGBA32UI";
    this.#points.needsUpdate = true;
    if (rows > this.#rows || rows < this.#rows / 4)
      this.#allocate(renderer, Math.ceil((rows * 1.25) / 2) * 2);
  }

  /** @param {import("three").WebGLRenderer} renderer @param {number} rows */
  #allocate(renderer, rows) {
    for (const target of this.#targets) target.dispose();
    this.#rows = rows;
    this.#targets = [0, 1].map(() => {
      const target = new WebGLRenderTarget(VERTEX_COLUMNS, rows, {
        format: RGBAIntegerFormat,
        type: UnsignedIntType,
        internalFormat: "RGBA32UI",
        minFilter: NearestFilter,
        magFilter: NearestFilter,
        depthBuffer: false,
        generateMipmaps: false,
      });
      renderer.initRenderTarget(target); // both are read before both are drawn
      return target;
    });
  }

  /**
   * @param {import("three").WebGLRenderer} renderer
   * @param {import("./depth_atlas.js").DepthAtlas} atlas just drawn
   * @param {ArrayLike<number>} towards all directions, of which these views are some
   * @param {{ first: number, count: number, lift: number, rows: number }} batch
   */
  gather(renderer, atlas, towards, { first, count, lift, rows }) {
    const uniforms = this.#material.uniforms;
    const [present, next] = this.#targets;
    for (let k = 0; k < count; k++) {
      const at = 3 * (first + k);
      uniforms.towards.value[k].set(towards[at], towards[at + 1], towards[at + 2], 0);
    }
    uniforms.points.value = this.#points;
    uniforms.before.value = present.texture;
    uniforms.atlas.value = atlas.texture;
    uniforms.rowX.value = atlas.rows.x;
    uniforms.rowY.value = atlas.rows.y;
    uniforms.rowZ.value = atlas.rows.z;
    uniforms.first.value = first;
    uniforms.count.value = count;
    uniforms.lift.value = lift;
    next.viewport.set(0, 0, VERTEX_COLUMNS, rows);
    renderer.setRenderTarget(next);
    renderer.render(this.#scene, this.#camera);
    this.#targets = [next, present];
  }

  /**
   * Reads the sums back: for files, tests and measurements.
   *
   * @param {import("three").WebGLRenderer} renderer
   * @param {number} rows
   * @returns {Uint32Array} four words per texel, row by row
   */
  read(renderer, rows) {
    const out = new Uint32Array(VERTEX_COLUMNS * rows * 4);
    renderer.readRenderTargetPixels(this.#targets[0], 0, 0, VERTEX_COLUMNS, rows, out);
    return out;
  }

  dispose() {
    for (const target of this.#targets) target.dispose();
    this.#targets = [];
    this.#rows = 0;
    this.#points?.dispose();
    this.#material.dispose();
  }
}
