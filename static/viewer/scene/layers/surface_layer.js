import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DoubleSide,
  FrontSide,
  GLSL3,
  Mesh,
  NoBlending,
  RawShaderMaterial,
  RGIntegerFormat,
  RedFormat,
  UnsignedIntType,
  Vector2,
  Vector3,
} from "three";
import { boxOf } from "../../geometry/box.js";
import { meanSide } from "../../geometry/mean_side.js";
import { componentsOf } from "../../colours/components.js";
import { DRAFT_FRAGMENT, DRAFT_VERTEX } from "./draft_shader.js";
import { DARK, luminance } from "../../colours/luminance.js";
import { CATEGORIES, NOT_FINITE } from "../../colours/palettes.js";
import { flatQuadIndex, quadIndex } from "../../geometry/quad_index.js";
import { SURFACE_FRAGMENT, SURFACE_VERTEX } from "./surface_shader.js";
import { isTriangle } from "../../geometry/triangle.js";

/** Numbers by which the shader knows the lighting modes. */
const LIGHTING = { none: 0, direct: 1, screen_space_ao: 2, object_space_ao: 3 };

/**
 * The surface of the shown cells.
 */
export class SurfaceLayer {
  mesh;
  /** @type {import("../../geometry/records.js").Surface | null} */
  surface = null;
  /** Of what is shown. @type {import("../../geometry/box.js").Box | null} */
  box = null;
  /** Mean side of a face. */
  edge = 1;
  uniforms;
  /** Colours of values beyond the map's range. */
  #ends = { above: NOT_FINITE, below: NOT_FINITE };
  #highFirst = false;
  #colours;
  #whole;
  #draft;
  #white;
  #open;

  /** @param {import("./cell_colours.js").CellColours} colours */
  constructor(colours) {
    this.#colours = colours;
    this.#white = new DataTexture(new Uint8Array([255]), 1, 1, RedFormat);
    this.#white.needsUpdate = true;
    this.#open = new DataTexture(new Uint32Array(2), 1, 1, RGIntegerFormat, UnsignedIntType);
    this.#open.internalFormat = "RG32UI";
    this.#open.needsUpdate = true;
    this.uniforms = {
      byCell: { value: false },
      outsideColour: { value: new Vector3(1, 1, 1) },
      insideColour: { value: new Vector3(1, 1, 0) },
      missingColour: { value: new Vector3(...componentsOf(NOT_FINITE)) },
      beyond: { value: false },
      firstBeyond: { value: new Vector3() },
      lastBeyond: { value: new Vector3() },
      cellValues: { value: colours.values },
      palette: { value: colours.palette },
      paletteScale: { value: 255 },
      occlusion: { value: /** @type {import("three").Texture} */ (this.#open) },
      occlusionShare: { value: 0 },
      fourByFour: { value: true },
      lighting: { value: 1 },
      shade: { value: 1 },
      screenShare: { value: 0 },
      screenOpenness: { value: /** @type {import("three").Texture} */ (this.#white) },
      screenScale: { value: new Vector2(1, 1) },
      screenOffset: { value: new Vector2(0, 0) },
      edgeInk: { value: 0 },
    };
    const material = (/** @type {string} */ vertexShader, /** @type {string} */ fragmentShader) =>
      new RawShaderMaterial({
        glslVersion: GLSL3,
        vertexShader,
        fragmentShader,
        uniforms: this.uniforms,
        side: DoubleSide,
        forceSinglePass: true,
        transparent: true, // to be drawn in its turn
        blending: NoBlending,
        polygonOffset: true,
        polygonOffsetFactor: 1,
        polygonOffsetUnits: 1,
      });
    this.#whole = material(SURFACE_VERTEX, SURFACE_FRAGMENT);
    this.#draft = material(DRAFT_VERTEX, DRAFT_FRAGMENT);
    this.mesh = new Mesh(new BufferGeometry(), this.#whole);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  /** @param {import("../../geometry/records.js").Surface | null} surface */
  set(surface) {
    const old = this.mesh.geometry;
    old.setIndex(null); // the shared index must outlive this geometry
    old.dispose();
    this.surface = surface;
    this.box = surface && boxOf(surface.positions);
    const geometry = new BufferGeometry();
    this.mesh.geometry = geometry;
    this.mesh.visible = surface !== null && surface.positions.length > 0;
    if (!surface) return;
    if (!surface.quads) markTriangles(surface);
    geometry.setAttribute("position", new BufferAttribute(surface.positions, 3));
    geometry.setAttribute("normal", new BufferAttribute(surface.normals, 4, true));
    geometry.setAttribute("cell", new BufferAttribute(surface.cells, 1));
    geometry.setAttribute("inside", new BufferAttribute(surface.inside, 1, true));
    geometry.setIndex(surface.quads ? quadIndex(surface.quads) : flatQuadIndex(surface.faces.length));
    geometry.setDrawRange(0, 6 * surface.faces.length);
    this.edge = meanSide(surface.positions, surface.quads, surface.faces.length);
    this.uniforms.fourByFour.value = surface.quads === null;
  }

  /**
   * Draw it plainly, edges and all.
   *
   * @param {boolean} draft
   * @param {number} ink of the edges, 0 to 1
   */
  setDraft(draft, ink) {
    this.mesh.material = this.material(draft);
    this.uniforms.edgeInk.value = ink;
  }

  /** By which it is drawn: in a draft, or else. @param {boolean} draft */
  material(draft) {
    return draft ? this.#draft : this.#whole;
  }

  /** Whether only fronts can be seen: all faces look outward, and the eye is outside. @param {boolean} fronts */
  set fronts(fronts) {
    this.#whole.side = this.#draft.side = fronts ? FrontSide : DoubleSide;
  }

  /** @param {import("../../lighting/lighting.js").LightingMode} mode */
  set lighting(mode) {
    this.uniforms.lighting.value = LIGHTING[mode] ?? 1;
  }

  /** Strength of the light's shade. @param {number} shade 0 to 1 */
  set shade(shade) {
    this.uniforms.shade.value = shade;
  }

  /**
   * @param {number} share of the gathered openness in the light
   * @param {import("three").Texture | null} texture its sums; null: none are drawn on
   */
  setOcclusion(share, texture) {
    this.uniforms.occlusionShare.value = texture ? share : 0;
    this.uniforms.occlusion.value = texture ?? this.#open;
  }

  /** @param {NonNullable<import("../types.js").SceneStatus["colour"]>} colour */
  setColour(colour) {
    this.uniforms.byCell.value = colour.by !== undefined && colour.by !== "sides";
    this.uniforms.paletteScale.value = colour.by && colour.by in CATEGORIES ? 1 : 255;
    if (colour.missing) this.uniforms.missingColour.value.set(...componentsOf(colour.missing));
    this.uniforms.beyond.value =
      colour.beyond === true && (colour.by === "quality" || colour.by === "attribute");
    this.#ends = { above: colour.above ?? this.#ends.above, below: colour.below ?? this.#ends.below };
    this.#showEnds();
    if (colour.outside) this.uniforms.outsideColour.value.set(...componentsOf(colour.outside));
    if (colour.inside) this.uniforms.insideColour.value.set(...componentsOf(colour.inside));
  }

  /** Whether any colour that a cell may have is dark. */
  get dark() {
    const { byCell, beyond, outsideColour, insideColour, missingColour, firstBeyond, lastBeyond } =
      this.uniforms;
    const sides = [outsideColour, insideColour];
    const singles = byCell.value
      ? [missingColour, ...(beyond.value ? [firstBeyond, lastBeyond] : [])]
      : sides;
    return (
      (byCell.value && this.#colours.dark) || singles.some(({ value }) => luminance(value.toArray()) < DARK)
    );
  }

  /** Whether the map's first colour is that of high values. @param {boolean} highFirst */
  set highFirst(highFirst) {
    this.#highFirst = highFirst;
    this.#showEnds();
  }

  #showEnds() {
    const { above, below } = this.#ends;
    const [first, last] = this.#highFirst ? [above, below] : [below, above];
    this.uniforms.firstBeyond.value.set(...componentsOf(first));
    this.uniforms.lastBeyond.value.set(...componentsOf(last));
  }

  dispose() {
    this.set(null);
    this.#white.dispose();
    this.#open.dispose();
    this.#whole.dispose();
    this.#draft.dispose();
  }
}

/** Sets the spare fourth number of a triangle's normals, by which the draft knows it. @param {import("../../geometry/records.js").Surface} surface */
function markTriangles({ positions, normals, faces }) {
  for (let face = 0; face < faces.length; face++)
    if (isTriangle(positions, 12 * face)) for (let k = 0; k < 4; k++) normals[16 * face + 4 * k + 3] = 32767;
}
