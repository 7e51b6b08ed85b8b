import { BREADTHS, STANDS } from "../../geometry/arrow_shape.js";

/** Parts of an arrow's length: its head's, and the radii of head and shaft. */
const HEAD = 0.34;
const HEAD_RADIUS = 0.105;
const SHAFT_RADIUS = 0.03;

/** What they are at least, in CSS pixels, as far as the arrow is long enough. */
const LEAST_HEAD = 6;
const LEAST_HEAD_RADIUS = 2.2;
const LEAST_SHAFT_RADIUS = 0.65;

/**
 * Arrows, each an instance of one body: from the middle of a face along its vector, or, where that would lie within the face's
 * cell, so that its tip is there. What is thin for its length stays as broad as a pixel or so. With a rim the body is larger by
 * so many pixels all round.
 */
export const ARROWS_VERTEX = `
precision highp float;
in vec4 ring;
in vec2 turn;
in vec3 place;
in vec3 vector;
in float inward;

uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform float reach;
uniform float pixelSize;
uniform float rim;

out vec3 vNormal;
out vec3 vView;

void main() {
  float size = length(vector);
  vec3 way = vector / max(size, 1e-20);
  float whole = reach * size;
  vec3 tail = (modelViewMatrix * vec4(place - inward * whole * way, 1.0)).xyz;
  vec3 axis = normalize(mat3(modelViewMatrix) * way);
  bool flat_ = projectionMatrix[3][3] == 1.0;
  float unit = flat_ ? pixelSize : pixelSize * max(-tail.z - 0.5 * whole * axis.z, 0.0);

  float head = max(${HEAD} * whole, min(float(${LEAST_HEAD}) * unit, 0.6 * whole));
  float broad = max(${HEAD_RADIUS} * whole, min(float(${LEAST_HEAD_RADIUS}) * unit, max(0.35 * whole, 0.6 * unit)));
  float thin = max(${SHAFT_RADIUS} * whole, min(float(${LEAST_SHAFT_RADIUS}) * unit, 0.6 * broad));
  float more = rim * unit;
  float stand = ring.x == ${STANDS.tail}.0 ? -more : ring.x == ${STANDS.neck}.0 ? whole - head - more : whole + 2.0 * more;
  float radius = ring.y == ${BREADTHS.none}.0 ? 0.0 : ring.y == ${BREADTHS.shaft}.0 ? thin + more : broad + 1.4 * more;

  vec3 aside = normalize(cross(axis, abs(axis.z) < 0.9 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0)));
  vec3 round = aside * turn.x + cross(axis, aside) * turn.y;
  vec3 view = tail + stand * axis + radius * round;
  vNormal = ring.z * round + ring.w * axis;
  vView = flat_ ? vec3(0.0, 0.0, 1.0) : -view;
  gl_Position = projectionMatrix * vec4(view, 1.0);
}
`;

/** One ink, darker where the body turns away from the eye; a rim has its colour everywhere. */
export const ARROWS_FRAGMENT = `
precision highp float;
in vec3 vNormal;
in vec3 vView;
uniform vec3 ink;
uniform float shade;
out vec4 pixel;
void main() {
  float facing = abs(dot(normalize(vNormal), normalize(vView)));
  pixel = vec4(ink * mix(1.0 - shade, 1.0, facing), 1.0);
}
`;
