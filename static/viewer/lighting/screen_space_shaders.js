export const GEOMETRY_VERTEX = `
precision highp float;
in vec3 position;
in vec4 normal;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat3 normalMatrix;
out vec3 vNormal;
out vec3 vView;
void main() {
  vec4 view = modelViewMatrix * vec4(position, 1.0);
  vView = projectionMatrix[3][3] == 1.0 ? vec3(0.0, 0.0, 1.0) : -view.xyz;
  vNormal = normalMatrix * normal.xyz;
  gl_Position = projectionMatrix * view;
}
`;

export const GEOMETRY_FRAGMENT = `
precision highp float;
in vec3 vNormal;
in vec3 vView;
out vec4 pixel;
void main() {
  vec3 n = normalize(vNormal);
  pixel = vec4((dot(n, vView) < 0.0 ? -n : n) * 0.5 + 0.5, 1.0);
}
`;

export const WHOLE_SCREEN = `
in vec2 position;
void main() { gl_Position = vec4(position, 0.0, 1.0); }
`;

const PLACE = `
precision highp float;
precision highp sampler2D;
uniform sampler2D depths;
uniform sampler2D normals;
uniform sampler2D open;
uniform mat4 unproject;
uniform vec2 size;
uniform float radius;
uniform float pixels;
uniform bool orthographic;
uniform vec2 step;
out vec4 pixel;

vec3 placeAt(vec2 at, float depth) {
  vec4 place = unproject * vec4(vec3(at / size, depth) * 2.0 - 1.0, 1.0);
  return place.xyz / place.w;
}

vec3 placeAt(ivec2 at) { return placeAt(vec2(at) + 0.5, texelFetch(depths, at, 0).r); }

vec3 normalAt(ivec2 at) { return normalize(texelFetch(normals, at, 0).rgb * 2.0 - 1.0); }
`;

/**
 * Light kept off by what stands within the radius: a spiral of samples whose weight falls off with distance, so that things far
 * in front of each other cast no halo (in the manner of McGuire et al. 2012, "Scalable ambient obscurance").
 */
export const OCCLUSION = `
${PLACE}
const int SAMPLES = 12;
const float TURNS = 5.0;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depths, at, 0).r;
  pixel = vec4(1.0);
  if (depth == 1.0) return;
  vec3 place = placeAt(gl_FragCoord.xy, depth);
  vec3 normal = normalAt(at);
  float reach = min(pixels / (orthographic ? 1.0 : -place.z), 0.25 * size.y);
  if (reach < 1.0) return;
  float turn = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) * 6.2831853;
  float sum = 0.0;
  for (int k = 0; k < SAMPLES; k++) {
    float share = (float(k) + 0.5) / float(SAMPLES);
    float angle = turn + share * TURNS * 6.2831853;
    ivec2 there = at + ivec2(round(vec2(cos(angle), sin(angle)) * max(1.0, share * reach)));
    if (any(lessThan(there, ivec2(0))) || any(greaterThanEqual(there, ivec2(size)))) continue;
    vec3 v = placeAt(there) - place;
    float vv = dot(v, v);
    float vn = dot(v, normal) - 0.02 * radius;
    float near = max(radius * radius - vv, 0.0) / (radius * radius);
    sum += near * near * max(vn, 0.0) / sqrt(vv + 1e-4 * radius * radius);
  }
  pixel = vec4(vec3(clamp(1.0 - 2.6 * sum / float(SAMPLES), 0.0, 1.0)), 1.0);
}
`;

export const BLUR = `
${PLACE}
void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float depth = texelFetch(depths, at, 0).r;
  pixel = vec4(1.0);
  if (depth == 1.0) return;
  vec3 place = placeAt(gl_FragCoord.xy, depth);
  vec3 normal = normalAt(at);
  float sum = 0.0;
  float weights = 0.0;
  for (int k = -3; k <= 3; k++) {
    ivec2 there = clamp(at + k * ivec2(step), ivec2(0), ivec2(size) - 1);
    vec3 v = placeAt(there) - place;
    float aside = abs(dot(v, normal)) / (0.1 * radius);
    float weight = max(0.0, 1.0 - aside) * max(0.0, dot(normalAt(there), normal)) * (4.0 - abs(float(k)));
    if (k == 0) weight = 4.0;
    sum += weight * texelFetch(open, there, 0).r;
    weights += weight;
  }
  pixel = vec4(vec3(sum / weights), 1.0);
}
`;
