// Where the volumes of triangles that straddle surfaces may light the map: a rectangle for each.
#include "techniques/caustics/lights.glsl"

layout(binding = 0) uniform sampler2D places;
layout(std430, binding = 1) readonly buffer Rays { vec4 rays[]; };
layout(std430, binding = 2) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 3) readonly buffer Lights { vec2 lights[]; };

layout(location = 0) flat out int triangle_number;

void main() {
  triangle_number = gl_VertexID / 6;
  gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // nowhere
  vec2 depths = lights[triangle_number];
  if (depths == kLands || depths == kMisses) return;
  vec2 low = vec2(1e30);
  vec2 high = vec2(-1e30);
  for (int corner = 0; corner < 3; ++corner) {
    vec4 ray = rays[corners[3 * triangle_number + corner]];
    vec2 near = ray.xy + depths.x * ray.zw;
    vec2 far = ray.xy + depths.y * ray.zw;
    low = min(low, min(near, far));
    high = max(high, max(near, far));
  }
  // By half a texel more: which texels on an edge are the triangle's is for the fragments to say.
  vec2 margin = 0.5 / vec2(textureSize(places, 0));
  low -= margin;
  high += margin;
  int vertex = gl_VertexID % 6;
  // Two triangles with one edge in common: 0 1 2 and 2 1 3.
  int at = vertex < 3 ? vertex : vertex == 3 ? 2 : vertex == 4 ? 1 : 3;
  gl_Position = vec4(2.0 * mix(low, high, vec2(at & 1, at >> 1)) - 1.0, 0.0, 1.0);
}
