import {
  BufferAttribute,
  BufferGeometry,
  Camera,
  DepthTexture,
  DoubleSide,
  GLSL3,
  LinearFilter,
  Matrix4,
  Mesh,
  NearestFilter,
  RGBAFormat,
  RawShaderMaterial,
  RedFormat,
  Scene,
  UnsignedByteType,
  UnsignedIntType,
  Vector2,
  WebGLRenderTarget,
} from "three";
import { BLUR, GEOMETRY_FRAGMENT, GEOMETRY_VERTEX, OCCLUSION, WHOLE_SCREEN } from "./screen_space_shaders.js";

/** Radius in which things darken each other, in mean edge lengths. */
const RADIUS = 5;

/** The normal, as a colour, where nothing is drawn: towards the eye, whatever was drawn before. */
const FACING = [0.5, 0.5, 1, 0];

/**
 * Openness to light estimated from what is on the screen: depth and normals of the surface, a ring of samples about each
 * pixel, and a blur that stops at edges. It covers the time until the true term is there.
 */
export class ScreenSpaceAO {
  #renderer;
  #geometryScene = new Scene();
  #screenScene = new Scene();
  #camera = new Camera();
  #mesh;
  #screen;
  #geometryMaterial;
  #occlusion;
  #blur;
  /** @type {WebGLRenderTarget | null} */
  #normals = null;
  /** @type {[WebGLRenderTarget, WebGLRenderTarget] | null} */
  #open = null;

  /** @param {import("three").WebGLRenderer} renderer */
  constructor(renderer) {
    this.#renderer = renderer;
    this.#geometryMaterial = new RawShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: GEOMETRY_VERTEX,
      fragmentShader: GEOMETRY_FRAGMENT,
      side: DoubleSide,
    });
    this.#mesh = new Mesh(new BufferGeometry(), this.#geometryMaterial);
    this.#mesh.frustumCulled = false;
    this.#geometryScene.add(this.#mesh);
    const uniforms = () => ({
      depths: { value: null },
      normals: { value: null },
      open: { value: null },
      unproject: { value: new Matrix4() },
      size: { value: new Vector2() },
      radius: { value: 0 },
      pixels: { value: 0 },
      orthographic: { value: false },
      step: { value: new Vector2() },
    });
    const screenMaterial = (/** @type {string} */ fragmentShader) =>
      new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader: WHOLE_SCREEN,
        fragmentShader,
        uniforms: uniforms(),
        depthTest: false,
        depthWrite: false,
      });
    this.#occlusion = screenMaterial(OCCLUSION);
    this.#blur = screenMaterial(BLUR);
    const triangle = new BufferGeometry();
    triangle.setAttribute("position", new BufferAttribute(new Float32Array([-1, -1, 3, -1, -1, 3]), 2));
    this.#screen = new Mesh(triangle, this.#occlusion);
    this.#screen.frustumCulled = false;
    this.#screenScene.add(this.#screen);
    for (const scene of [this.#geometryScene, this.#screenScene]) scene.matrixWorldAutoUpdate = false;
  }

  /** By which it is drawn. */
  get materials() {
    return [this.#geometryMaterial, this.#occlusion, this.#blur];
  }

  /** Openness per pixel in red. @returns {import("three").Texture | null} */
  get texture() {
    return this.#open?.[0].texture ?? null;
  }

  /**
   * @param {import("three").BufferGeometry} geometry
   * @param {import("three").PerspectiveCamera | import("three").OrthographicCamera} camera
   * @param {{ width: number, height: number, edge: number, perUnit: number }} view size in pixels; mean edge length; pixels
   *   to a unit of length at distance 1 (perspective) or everywhere (orthographic)
   */
  draw(geometry, camera, { width, height, edge, perUnit }) {
    const renderer = this.#renderer;
    const { normals, open } = this.#allocate(width, height);
    const radius = RADIUS * edge;
    this.#mesh.geometry = geometry;
    const gl = /** @type {WebGL2RenderingContext} */ (renderer.getContext());
    renderer.setRenderTarget(normals);
    renderer.state.buffers.depth.setMask(true);
    gl.clearBufferfv(gl.COLOR, 0, FACING);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    renderer.render(this.#geometryScene, camera);
    for (const material of [this.#occlusion, this.#blur]) {
      const uniforms = material.uniforms;
      uniforms.depths.value = normals.depthTexture;
      uniforms.normals.value = normals.texture;
      uniforms.unproject.value.copy(camera.projectionMatrixInverse);
      uniforms.size.value.set(width, height);
      uniforms.radius.value = radius;
      uniforms.pixels.value = radius * perUnit;
      uniforms.orthographic.value = camera.projectionMatrix.elements[15] === 1;
    }
    this.#pass(this.#occlusion, open[0], null, 0, 0);
    this.#pass(this.#blur, open[1], open[0], 1, 0);
    this.#pass(this.#blur, open[0], open[1], 0, 1);
  }

  /**
   * @param {RawShaderMaterial} material
   * @param {WebGLRenderTarget} target
   * @param {WebGLRenderTarget | null} source
   * @param {number} dx
   * @param {number} dy
   */
  #pass(material, target, source, dx, dy) {
    material.uniforms.open.value = source?.texture ?? null;
    material.uniforms.step.value.set(dx, dy);
    this.#screen.material = material;
    this.#renderer.setRenderTarget(target);
    this.#renderer.render(this.#screenScene, this.#camera);
  }

  /** @param {number} width @param {number} height */
  #allocate(width, height) {
    if (this.#normals && this.#open && this.#normals.width === width && this.#normals.height === height) {
      return { normals: this.#normals, open: this.#open };
    }
    this.forget();
    this.#normals = new WebGLRenderTarget(width, height, {
      format: RGBAFormat,
      type: UnsignedByteType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthTexture: new DepthTexture(width, height, UnsignedIntType),
      generateMipmaps: false,
    });
    const make = () =>
      new WebGLRenderTarget(width, height, {
        format: RedFormat,
        type: UnsignedByteType,
        minFilter: LinearFilter,
        magFilter: LinearFilter,
        depthBuffer: false,
        generateMipmaps: false,
      });
    this.#open = [make(), make()];
    return { normals: this.#normals, open: this.#open };
  }

  /** Gives up its targets, to make new ones when next asked. */
  forget() {
    this.#normals?.depthTexture?.dispose();
    this.#normals?.dispose();
    this.#open?.forEach((target) => target.dispose());
    this.#normals = this.#open = null;
  }

  dispose() {
    this.forget();
    this.#screen.geometry.dispose();
    for (const material of [this.#geometryMaterial, this.#occlusion, this.#blur]) material.dispose();
  }
}
