import {
  DepthTexture,
  FrontSide,
  GLSL3,
  InstancedBufferGeometry,
  LessEqualCompare,
  LinearFilter,
  Mesh,
  NearestFilter,
  RawShaderMaterial,
  RedFormat,
  Camera,
  Scene,
  UnsignedByteType,
  UnsignedIntType,
  Vector4,
  WebGLRenderTarget,
} from "three";

/** Most views that one batch may hold. */
export const TILES = 16;

const VERTEX = `
precision highp float;
precision highp int;
in vec3 position;
uniform vec4 rowX[${TILES}];
uniform vec4 rowY[${TILES}];
uniform vec4 rowZ[${TILES}];
void main() {
  vec4 p = vec4(position, 1.0);
  int tile = gl_InstanceID;
  gl_Position = vec4(dot(rowX[tile], p), dot(rowY[tile], p), dot(rowZ[tile], p), 1.0);
}
`;

const FRAGMENT = `
precision mediump float;
out vec4 pixel;
void main() { pixel = vec4(1.0); }
`;

/**
 * Depth of the surface's near sides as seen from several directions at once: square tiles of one depth texture, all drawn by one instanced
 * call. The views hold the whole surface, so that no tile spills into another.
 */
export class DepthAtlas {
  target;
  /** Rows that carry a point to the atlas and to depth, all from -1 to 1. */
  rows = {
    x: Array.from({ length: TILES }, () => new Vector4()),
    y: Array.from({ length: TILES }, () => new Vector4()),
    z: Array.from({ length: TILES }, () => new Vector4()),
  };
  #scene = new Scene();
  #mesh;
  #camera = new Camera();
  #material;

  /** @param {number} side pixels of a tile's side @param {number} columns tiles in a row, and rows of tiles */
  constructor(side, columns) {
    this.side = side;
    this.columns = columns;
    const depth = new DepthTexture(side * columns, side * columns, UnsignedIntType);
    depth.compareFunction = LessEqualCompare;
    depth.minFilter = depth.magFilter = LinearFilter;
    this.target = new WebGLRenderTarget(side * columns, side * columns, {
      format: RedFormat,
      type: UnsignedByteType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthTexture: depth,
      generateMipmaps: false,
    });
    this.#material = depthMaterial(this.rows);
    this.#mesh = new Mesh(new InstancedBufferGeometry(), this.#material);
    this.#mesh.frustumCulled = false;
    this.#scene.add(this.#mesh);
    this.#scene.matrixWorldAutoUpdate = false;
  }

  /** @returns {import("three").Texture} */
  get texture() {
    return /** @type {import("three").Texture} */ (this.target.depthTexture);
  }

  /** @param {import("three").BufferGeometry | null} geometry whose buffers are shared, not owned */
  setGeometry(geometry) {
    const shared = new InstancedBufferGeometry();
    if (geometry) {
      shared.setAttribute("position", geometry.getAttribute("position"));
      shared.setIndex(geometry.index);
      shared.setDrawRange(geometry.drawRange.start, geometry.drawRange.count);
    }
    const old = this.#mesh.geometry;
    old.setIndex(null);
    old.deleteAttribute("position");
    old.dispose();
    this.#mesh.geometry = shared;
  }

  /**
   * @param {import("three").WebGLRenderer} renderer
   * @param {{ x: number[], y: number[], z: number[] }[]} views at most columns squared
   * @param {number} first number of the first view among all: each has its own tile whatever the batch, so that sums come out
   *   the same to the last digit
   */
  draw(renderer, views, first) {
    const { columns, rows } = this;
    views.forEach((view, k) => {
      const tile = (first + k) % columns ** 2;
      const cx = (2 * (tile % columns) + 1) / columns - 1;
      const cy = (2 * Math.floor(tile / columns) + 1) / columns - 1;
      rows.x[k].fromArray(view.x).divideScalar(columns);
      rows.x[k].w += cx;
      rows.y[k].fromArray(view.y).divideScalar(columns);
      rows.y[k].w += cy;
      rows.z[k].fromArray(view.z);
    });
    /** @type {InstancedBufferGeometry} */ (this.#mesh.geometry).instanceCount = views.length;
    renderer.setRenderTarget(this.target);
    const gl = /** @type {WebGL2RenderingContext} */ (renderer.getContext());
    renderer.state.buffers.depth.setMask(true);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    renderer.render(this.#scene, this.#camera);
  }

  dispose() {
    this.setGeometry(null);
    this.#material.dispose();
    this.target.depthTexture?.dispose();
    this.target.dispose();
  }
}

/** @param {{ x: Vector4[], y: Vector4[], z: Vector4[] }} rows of the views */
export function depthMaterial({ x, y, z }) {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { rowX: { value: x }, rowY: { value: y }, rowZ: { value: z } },
    colorWrite: false,
    side: FrontSide,
    polygonOffset: true,
    polygonOffsetFactor: 1.5,
    polygonOffsetUnits: 4,
  });
}
