import { ArrowsLayer } from "./arrows_layer.js";
import { MarksLayer } from "./marks_layer.js";
import { around } from "../../geometry/box.js";
import { CATEGORIES } from "../../colours/palettes.js";
import { CellColours } from "./cell_colours.js";
import { CurvesLayer } from "./curves_layer.js";
import { Gizmo } from "../camera/gizmo.js";
import { HighlightLayer } from "./highlight_layer.js";
import { IrregularLayer } from "./irregular_layer.js";
import { LinesLayer } from "./lines_layer.js";
import { isApart } from "../../state/structure.js";
import { fading } from "./lines_shader.js";
import { OutlineLayer } from "./outline_layer.js";
import { PlaneLayer } from "./plane_layer.js";
import { ReferenceLayer } from "./reference_layer.js";
import { release } from "./release.js";
import { SeeThroughLayer } from "./see_through_layer.js";
import { SilhouetteLayer } from "./silhouette_layer.js";
import { SurfaceLayer } from "./surface_layer.js";
import { materialsIn } from "../frame/programs.js";
import { under } from "./under.js";

/** Ink of a surface edge by the number of shown cells around it: darkness-coded edges. Row 0: all alike. */
const EDGE_STYLES = [1, 0.3, 0.65, 1].map((ink) => ({ colour: "#000000", ink }));

/** Ink of an edge in the mean, by separation mode. */
const MEAN_INK = { lines: 1, darkness_coded_edges: EDGE_STYLES[2].ink, fissure: 0, rounded: 0 };

const NO_EDGES = new Float32Array(0);

/** Parts of the status that change how the layers look. */
const LOOKS = /** @type {const} */ ([
  "colour",
  "separation",
  "silhouette",
  "see_through",
  "arrows",
  "irregular",
  "structure",
  "compare",
  "lighting",
  "background",
]);

/**
 * All that is drawn, in the painter's five storeys, and how the status makes it look.
 */
export class Layers {
  colours = new CellColours();
  surface = new SurfaceLayer(this.colours);
  edges = new LinesLayer(EDGE_STYLES, { fade: true, toned: this.surface.uniforms });
  silhouette = new SilhouetteLayer();
  irregular = new IrregularLayer();
  arrows = new ArrowsLayer();
  marks = new MarksLayer();
  curves = new CurvesLayer();
  plane = new PlaneLayer();
  highlight = new HighlightLayer();
  outline = new OutlineLayer();
  seeThrough = new SeeThroughLayer(this.surface.uniforms);
  reference = new ReferenceLayer();
  gizmo = new Gizmo();
  #painter;
  /** @type {Map<string, string>} */
  #looks = new Map();
  /** Whether all cells are known to be valid at their corners, so that their faces look outward. */
  outward = false;
  /** Whether the lines are those of the present surface. */
  #edged = false;

  /** @param {import("../frame/painter.js").Painter} painter */
  constructor(painter) {
    this.#painter = painter;
    painter.backdrop.add(this.silhouette.group);
    painter.model.add(this.surface.mesh);
    painter.ink.add(
      this.arrows.group,
      this.edges.group,
      this.marks.group,
      this.irregular.group,
      this.curves.group,
    );
    painter.overlay.add(this.plane.group, this.highlight.group, this.outline.group);
    painter.veil.add(this.seeThrough.group, this.reference.group);
  }

  /** @param {import("../../geometry/records.js").Surface | null} surface */
  setSurface(surface) {
    this.surface.set(surface);
    this.irregular.among = surface?.faces.length ?? 0;
    this.#edged = false;
    this.arrows.stale = true;
    this.highlight.set(surface, null);
  }

  /** @param {import("../../geometry/records.js").Silhouette | null} silhouette */
  setSilhouette(silhouette) {
    this.silhouette.set(silhouette);
    this.#painter.renewBackdrop();
  }

  /** @param {Float32Array | null} positions @param {boolean} highFirst whether the map's first colour is that of high values */
  setCellColours(positions, highFirst) {
    this.surface.highFirst = highFirst;
    this.colours.setPositions(positions);
    this.surface.uniforms.cellValues.value = this.colours.values;
  }

  /**
   * Takes on the looks that a status holds.
   *
   * @param {import("../types.js").SceneStatus} status
   * @returns {boolean} whether any is new
   */
  look(status) {
    let changed = false;
    for (const part of LOOKS) {
      const look = JSON.stringify(status[part]);
      if (look === undefined || look === this.#looks.get(part)) continue;
      this.#looks.set(part, look);
      changed = true;
    }
    if (!changed) return false;
    const { colour, separation, silhouette, irregular, background } = status;
    if (background) this.#painter.background = background;
    if (colour) {
      this.surface.setColour(colour);
      if (colour.by && colour.by in CATEGORIES) this.colours.setMap(colour.by);
      else if (colour.map) this.colours.setMap(colour.map, colour);
      this.edges.darkBelow = this.seeThrough.darkBelow = this.surface.dark;
    }
    if (separation?.line_opacity !== undefined) this.edges.opacity = separation.line_opacity;
    if (separation?.line_width !== undefined)
      this.edges.width = this.seeThrough.lineWidth = separation.line_width;
    if (status.see_through) this.seeThrough.look(status.see_through);
    if (status.compare?.reference) this.reference.look(status.compare.reference);
    if (status.arrows) this.arrows.look(status.arrows);
    if (status.lighting?.shade !== undefined) this.surface.shade = status.lighting.shade;
    if (silhouette !== undefined) {
      this.silhouette.strength = silhouette;
      this.#painter.renewBackdrop();
    }
    if (irregular) {
      this.irregular.setPalette(irregular.palette ?? "standard");
      this.irregular.setMode(irregular.mode ?? 1, irregular.boundary ?? false);
      this.curves.palette = irregular.palette ?? "standard";
    }
    if (status.structure) {
      const apart = isApart(status.structure);
      // Arcs are drawn as such; and what lies between blocks has no place while they are apart.
      this.irregular.group.visible = status.structure.kind !== "arcs" && !apart;
      this.marks.hidden = apart;
    }
    return true;
  }

  /** All that is drawn is within; null where nothing is. */
  get box() {
    const { surface, silhouette, seeThrough, reference, irregular, arrows, marks, curves, plane, outline } =
      this;
    const parts = [
      surface,
      silhouette,
      seeThrough,
      reference,
      irregular,
      arrows,
      marks,
      curves,
      plane,
      outline,
    ];
    return around(parts.map(({ box }) => box));
  }

  /** Edges of the surface. @returns {number} */
  get edgeCount() {
    return (this.surface.surface?.edges?.length ?? 0) / 6;
  }

  /** What of the surface is drawn. @returns {import("../scene_like.js").DrawnCounts} */
  get counts() {
    const { surface } = this.surface;
    if (!surface) return { faces: 0, triangles: 0, edges: 0, cells: 0 };
    return {
      faces: surface.faces.length,
      triangles: 2 * surface.faces.length,
      edges: this.edgeCount,
      cells: new Set(surface.cells).size,
    };
  }

  /** @param {Parameters<LinesLayer["view"]>[0] & { draft: boolean, outside: boolean }} view outside: so stands the eye */
  view(view) {
    const { surface } = this.surface;
    const edged = this.edgeCount > 0;
    if (!view.draft && !this.#edged) {
      this.edges.set(
        surface?.edges ?? NO_EDGES,
        surface?.edge_cells.length ? surface.edge_cells.map(darkness) : null,
        surface && under(surface),
      );
      this.#edged = true;
    }
    this.edges.group.visible = edged && !view.draft;
    this.surface.setDraft(view.draft, this.#draftInk(view));
    this.surface.fronts = surface?.two_sided || (this.outward && view.outside);
    this.silhouette.draft = view.draft;
    for (const layer of [
      this.edges,
      this.irregular,
      this.arrows,
      this.marks,
      this.curves,
      this.plane,
      this.highlight,
      this.outline,
      this.seeThrough,
    ])
      layer.view(view);
  }

  /**
   * Ink of all edges alike: as much as the lines have in the mean. A draft needs no lines to know where edges are.
   *
   * @param {{ pixel: number, pixelRatio: number }} view
   */
  #draftInk({ pixel, pixelRatio }) {
    const { surface, edge } = this.surface;
    const thinned = fading(edge / pixel);
    const ink = MEAN_INK[surface?.mode ?? "fissure"];
    return this.edges.opacity * ink * thinned * Math.min(1, this.edges.width * pixelRatio);
  }

  /** By which everything is drawn. @returns {Set<import("three").Material>} */
  get materials() {
    const { surface, silhouette, gizmo } = this;
    const { backdrop, ink, overlay, veil } = this.#painter;
    const found = [backdrop, ink, overlay, veil, gizmo.scene].map(materialsIn);
    for (const layer of [surface, silhouette])
      for (const draft of [true, false]) found.push(new Set([layer.material(draft)]));
    return new Set(found.flatMap((some) => [...some]));
  }

  /** The context is lost: gives up what lay in it. */
  forget() {
    const { backdrop, model, ink, overlay, veil } = this.#painter;
    for (const root of [backdrop, model, ink, overlay, veil, this.gizmo.scene]) release(root);
    this.#painter.forget();
  }

  dispose() {
    const { surface, edges, silhouette, irregular, arrows, marks, curves } = this;
    const { plane, highlight, outline, seeThrough, reference, gizmo, colours } = this;
    for (const layer of [
      surface,
      edges,
      silhouette,
      irregular,
      arrows,
      marks,
      curves,
      plane,
      highlight,
      outline,
      seeThrough,
      reference,
      gizmo,
      colours,
    ])
      layer.dispose();
  }
}

/** Row of the styles by the number of shown cells around an edge. @param {number} cells */
function darkness(cells) {
  return Math.min(cells, EDGE_STYLES.length - 1);
}
