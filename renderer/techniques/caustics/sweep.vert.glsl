// Where the volumes of triangles that straddle surfaces may light the map: a triangle or a rectangle for each.
#include "techniques/caustics/lights.glsl"
#include "techniques/caustics/triangles.glsl"

layout(binding = 0) uniform sampler2D places;
layout(std430, binding = 1) readonly buffer Rays { vec4 rays[]; };
layout(std430, binding = 2) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 3) readonly buffer Lights { vec2 lights[]; };
layout(std430, binding = 4) readonly buffer Ways { vec2 ways[]; };
layout(std430, binding = 5) readonly buffer Spots { vec2 spots[]; };

// Of the triangle and its corners: the fragments' own reads of buffers would take most of the time.
layout(location = 0) flat out uvec3 corner;
layout(location = 1) flat out vec3 flux;
layout(location = 2) flat out vec3 area;
layout(location = 3) flat out vec4 corner_ray[3];
layout(location = 6) flat out vec4 corner_way_spot[3];

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Corners of a triangle that holds all these points, its edges along those of the triangle in their middle.
vec2[3] triangle_around(vec2 near[3], vec2 far[3], vec2 margin) {
  vec2 middle[3];
  for (int i = 0; i < 3; ++i) middle[i] = 0.5 * (near[i] + far[i]);
  float turn = sign(cross2(middle[1] - middle[0], middle[2] - middle[0]));
  vec2 outward[3];
  float reach[3];
  for (int i = 0; i < 3; ++i) {
    vec2 edge = middle[(i + 1) % 3] - middle[i];
    outward[i] = turn * vec2(edge.y, -edge.x);
    reach[i] = -1e30;
    for (int j = 0; j < 3; ++j) reach[i] = max(reach[i], max(dot(outward[i], near[j]), dot(outward[i], far[j])));
    reach[i] += dot(abs(outward[i]), margin);
  }
  vec2 around[3];
  for (int i = 0; i < 3; ++i) {
    int before = (i + 2) % 3;
    vec2 a = outward[before], b = outward[i];
    around[i] = (reach[before] * vec2(b.y, -b.x) + reach[i] * vec2(-a.y, a.x)) / cross2(a, b);
  }
  return around;
}

void main() {
  int triangle_number = gl_VertexID / 6;
  corner = uvec3(0u);
  flux = area = vec3(0.0);
  for (int i = 0; i < 3; ++i) corner_ray[i] = corner_way_spot[i] = vec4(0.0);
  gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // nowhere
  vec2 depths = lights[triangle_number];
  if (depths == kLands || depths == kMisses) return;
  corner = uvec3(corners[3 * triangle_number], corners[3 * triangle_number + 1], corners[3 * triangle_number + 2]);
  flux = triangles[triangle_number].flux.rgb;
  area = triangles[triangle_number].area.xyz;
  vec2 near[3], far[3];
  vec2 low = vec2(1e30);
  vec2 high = vec2(-1e30);
  for (int i = 0; i < 3; ++i) {
    vec4 ray = corner_ray[i] = rays[corner[i]];
    corner_way_spot[i] = vec4(ways[corner[i]], spots[corner[i]]);
    near[i] = ray.xy + depths.x * ray.zw;
    far[i] = ray.xy + depths.y * ray.zw;
    low = min(low, min(near[i], far[i]));
    high = max(high, max(near[i], far[i]));
  }
  // By some of a texel more: which texels on an edge are the triangle's is for the fragments to say.
  vec2 margin = 0.25 / vec2(textureSize(places, 0));
  low -= margin;
  high += margin;
  int vertex = gl_VertexID % 6;
  vec2 around[3] = triangle_around(near, far, margin);
  // Where light folds that may be without end; the rectangle is not.
  vec2 size = high - low;
  if (abs(cross2(around[1] - around[0], around[2] - around[0])) < 2.0 * size.x * size.y) {
    if (vertex < 3) gl_Position = vec4(2.0 * around[vertex] - 1.0, 0.0, 1.0);
    return;
  }
  // Two triangles with one edge in common: 0 1 2 and 2 1 3.
  int at = vertex < 3 ? vertex : vertex == 3 ? 2 : vertex == 4 ? 1 : 3;
  gl_Position = vec4(2.0 * mix(low, high, vec2(at & 1, at >> 1)) - 1.0, 0.0, 1.0);
}
