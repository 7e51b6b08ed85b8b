import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GLSL3,
  Mesh,
  NearestFilter,
  RawShaderMaterial,
  RedIntegerFormat,
  Scene,
  UnsignedIntType,
  Vector3,
  Triangle,
  Ray,
  WebGLRenderTarget,
} from "three";
import { flatQuadIndex } from "../../geometry/quad_index.js";

const VERTEX = `
precision highp float;
in vec3 position;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
flat out uint row;
void main() {
  row = uint(gl_VertexID >> 2) + 1u;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`;

const FRAGMENT = `
precision highp float;
precision highp int;
flat in uint row;
out uint pixel;
void main() { pixel = row; }
`;

/**
 * Tells which face stands under a pixel: the surface is drawn into that one pixel with each face's row for a colour.
 */
export class Picker {
  #renderer;
  scene = new Scene();
  #mesh;
  #material;
  #target = new WebGLRenderTarget(1, 1, {
    format: RedIntegerFormat,
    type: UnsignedIntType,
    internalFormat: "R32UI",
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    generateMipmaps: false,
  });
  #answer = new Uint32Array(1);
  /** @type {import("../../geometry/records.js").Surface | null} */
  surface = null;
  #ready = false;

  /** @param {import("three").WebGLRenderer} renderer */
  constructor(renderer) {
    this.#renderer = renderer;
    this.#material = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      side: DoubleSide,
      uniforms: {},
    });
    this.#mesh = new Mesh(new BufferGeometry(), this.#material);
    this.#mesh.frustumCulled = false;
    this.scene.add(this.#mesh);
    this.scene.matrixWorldAutoUpdate = false;
  }

  /** @param {import("../../geometry/records.js").Surface | null} surface */
  set(surface) {
    this.surface = surface;
    this.#ready = false;
  }

  /** Corners of every face four by four: the surface's own, or spread out once where faces share vertices. */
  #prepare() {
    const surface = /** @type {import("../../geometry/records.js").Surface} */ (this.surface);
    const old = this.#mesh.geometry;
    old.setIndex(null);
    old.dispose();
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(cornersOf(surface), 3));
    geometry.setIndex(flatQuadIndex(surface.faces.length));
    geometry.setDrawRange(0, 6 * surface.faces.length);
    this.#mesh.geometry = geometry;
    this.#ready = true;
  }

  /**
   * @param {import("three").PerspectiveCamera | import("three").OrthographicCamera} camera
   * @param {number} x device pixels from the left
   * @param {number} y device pixels from the top
   * @param {number} width of the whole picture
   * @param {number} height
   * @returns {number} row of the face in the surface, -1 where there is none
   */
  rowAt(camera, x, y, width, height) {
    if (!this.surface || this.surface.faces.length === 0) return -1;
    if (!this.#ready) this.#prepare();
    const renderer = this.#renderer;
    camera.setViewOffset(width, height, Math.floor(x), Math.floor(y), 1, 1);
    renderer.setRenderTarget(this.#target);
    const gl = /** @type {WebGL2RenderingContext} */ (renderer.getContext());
    renderer.state.buffers.depth.setMask(true);
    gl.clearBufferuiv(gl.COLOR, 0, [0, 0, 0, 0]);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    renderer.render(this.scene, camera);
    camera.clearViewOffset();
    gl.readPixels(0, 0, 1, 1, gl.RED_INTEGER, gl.UNSIGNED_INT, this.#answer);
    renderer.setRenderTarget(null);
    return this.#answer[0] - 1;
  }

  /**
   * Where a ray meets a face.
   *
   * @param {number} row
   * @param {{ origin: Vector3, direction: Vector3 }} ray
   * @returns {Vector3 | null}
   */
  meet(row, { origin, direction }) {
    const surface = /** @type {import("../../geometry/records.js").Surface} */ (this.surface);
    const [a, b, c, d] = [0, 1, 2, 3].map((k) => {
      const id = surface.quads ? surface.quads[4 * row + k] : 4 * row + k;
      return new Vector3().fromArray(surface.positions, 3 * id);
    });
    const ray = new Ray(origin, direction);
    const hit = new Vector3();
    for (const { a: p, b: q, c: r } of [new Triangle(a, b, c), new Triangle(a, c, d)]) {
      if (ray.intersectTriangle(p, q, r, false, hit)) return hit;
    }
    return null;
  }

  dispose() {
    this.#mesh.geometry.setIndex(null);
    this.#mesh.geometry.dispose();
    this.#material.dispose();
    this.#target.dispose();
  }
}

/** @param {import("../../geometry/records.js").Surface} surface @returns {Float32Array} */
function cornersOf({ positions, quads }) {
  if (!quads) return positions;
  const corners = new Float32Array(3 * quads.length);
  for (let k = 0; k < quads.length; k++) {
    const from = 3 * quads[k];
    corners[3 * k] = positions[from];
    corners[3 * k + 1] = positions[from + 1];
    corners[3 * k + 2] = positions[from + 2];
  }
  return corners;
}
