import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  GLSL3,
  Group,
  Mesh,
  Points,
  RawShaderMaterial,
} from "three";
import { componentsOf } from "../../colours/components.js";
import { MARK_STYLES } from "../../colours/marks.js";
import { around, boxOf } from "../../geometry/box.js";
import { flatQuadIndex } from "../../geometry/quad_index.js";
import { LinesLayer } from "./lines_layer.js";
import { FILM_FRAGMENT, FILM_VERTEX } from "./film_shader.js";

/** CSS pixels that a point is broad. */
const POINT = 8;

/** Of faces: the surface's own colours and lines stay readable below. */
const OPACITY = 0.72;

// Points stand a little nearer to the eye than they are, so that the surface they lie on does not cut them.
const POINTS_VERTEX = `
precision highp float;
in vec3 position;
in vec3 colour;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform float size;
uniform float pull;
out vec3 vColour;
void main() {
  vColour = colour;
  vec4 place = modelViewMatrix * vec4(position, 1.0);
  place.z += pull;
  gl_Position = projectionMatrix * place;
  gl_PointSize = size;
}
`;

const POINTS_FRAGMENT = `
precision highp float;
in vec3 vColour;
out vec4 pixel;
void main() {
  float away = length(gl_PointCoord - 0.5) * 2.0;
  if (away > 1.0) discard;
  pixel = vec4(away > 0.72 ? vec3(1.0) : vColour, 1.0);
}
`;

/**
 * What is drawn over the surface: faces as a film on it, curves, and points; tested against the model's depth.
 */
export class MarksLayer {
  group = new Group();
  /** Whether none of it is drawn now. */
  hidden = false;
  #edges = new LinesLayer([...MARK_STYLES]);
  #faces;
  #points;
  /** @type {import("../../geometry/box.js").Box | null} */
  box = null;

  constructor() {
    this.#faces = new Mesh(
      new BufferGeometry(),
      material(FILM_VERTEX, FILM_FRAGMENT, {
        uniforms: { opacity: { value: OPACITY } },
        depthWrite: false,
        polygonOffset: true,
        polygonOffsetFactor: -1,
        polygonOffsetUnits: -2,
      }),
    );
    this.#points = new Points(
      new BufferGeometry(),
      material(POINTS_VERTEX, POINTS_FRAGMENT, { uniforms: { size: { value: POINT }, pull: { value: 0 } } }),
    );
    for (const one of [this.#faces, this.#points]) {
      one.frustumCulled = false;
      one.visible = false;
    }
    this.#edges.width = 2.5;
    this.group.add(this.#faces, this.#edges.group, this.#points);
  }

  /** @param {import("../../geometry/records.js").Marks | null} marks */
  set(marks) {
    this.box = marks && around([boxOf(marks.faces), boxOf(marks.edges), boxOf(marks.points)]);
    const { faces, face_colours, edges, edge_colours, points, point_colours } = marks ?? NOTHING;
    this.#edges.set(edges, edge_colours);
    this.#edges.group.visible = edges.length > 0;
    fill(this.#faces, faces, coloured(face_colours, 4, FILMS));
    if (face_colours.length) {
      this.#faces.geometry.setIndex(flatQuadIndex(face_colours.length));
      this.#faces.geometry.setDrawRange(0, 6 * face_colours.length);
    }
    fill(this.#points, points, coloured(point_colours, 1, INKS));
  }

  /** @param {Parameters<LinesLayer["view"]>[0] & { draft: boolean }} view */
  view(view) {
    this.group.visible = !view.draft && !this.hidden;
    this.#edges.view(view);
    const { uniforms } = this.#points.material;
    uniforms.size.value = POINT * view.pixelRatio;
    uniforms.pull.value = view.pixel * POINT * view.pixelRatio;
  }

  dispose() {
    this.#edges.dispose();
    for (const one of [this.#faces, this.#points]) {
      one.geometry.setIndex(null); // shared with the surface
      one.geometry.dispose();
      one.material.dispose();
    }
  }
}

const INKS = MARK_STYLES.map(({ colour }) => bytesOf(colour));
const FILMS = MARK_STYLES.map(({ colour, film }) => bytesOf(film ?? colour));

/** @type {import("../../geometry/records.js").Marks} */
const NOTHING = {
  faces: new Float32Array(0),
  face_colours: new Uint8Array(0),
  edges: new Float32Array(0),
  edge_colours: new Uint8Array(0),
  points: new Float32Array(0),
  point_colours: new Uint8Array(0),
  counts: {},
};

/** @param {string} hex */
function bytesOf(hex) {
  return componentsOf(hex).map((part) => Math.round(255 * part));
}

/** @param {string} vertexShader @param {string} fragmentShader @param {Partial<RawShaderMaterial>} how */
function material(vertexShader, fragmentShader, how) {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader,
    fragmentShader,
    transparent: true, // to be drawn in its turn
    side: DoubleSide,
    forceSinglePass: true,
    ...how,
  });
}

/** Colours of rows, so many times each. @param {Uint8Array} rows @param {number} times @param {number[][]} palette */
function coloured(rows, times, palette) {
  const colours = new Uint8Array(3 * times * rows.length);
  rows.forEach((row, k) => {
    for (let corner = 0; corner < times; corner++) colours.set(palette[row], 3 * (times * k + corner));
  });
  return colours;
}

/** @param {Mesh | Points} drawn @param {Float32Array} positions @param {Uint8Array} colours */
function fill(drawn, positions, colours) {
  drawn.geometry.setIndex(null);
  drawn.geometry.dispose();
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("colour", new BufferAttribute(colours, 3, true));
  drawn.geometry = geometry;
  drawn.visible = positions.length > 0;
}
