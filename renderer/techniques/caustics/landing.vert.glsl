// Triangles of the water where their corners land.
#include "techniques/caustics/lights.glsl"
#include "techniques/caustics/triangles.glsl"

layout(std430, binding = 1) readonly buffer Hits { vec4 hits[]; };
layout(std430, binding = 2) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 3) readonly buffer Lights { vec2 lights[]; };
layout(std430, binding = 5) readonly buffer Spots { vec2 spots[]; };
layout(std430, binding = 6) readonly buffer Rays { vec4 rays[]; };

layout(location = 0) out float way;
layout(location = 1) out float depth;
layout(location = 2) out vec2 spot;
layout(location = 3) flat out vec3 flux;
layout(location = 4) flat out vec3 area;
layout(location = 5) out vec2 ray_step;

void main() {
  int triangle_number = gl_VertexID / 3;
  way = depth = 0.0;
  spot = ray_step = vec2(0.0);
  flux = area = vec3(0.0);
  gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // nowhere
  if (lights[triangle_number] != kLands) return;
  area = triangles[triangle_number].area.xyz;
  flux = triangles[triangle_number].flux.rgb;
  ray_step = rays[corners[gl_VertexID]].zw;
  vec4 hit = hits[corners[gl_VertexID]];
  depth = hit.z;
  way = hit.w;
  spot = spots[corners[gl_VertexID]];
  gl_Position = vec4(2.0 * hit.xy - 1.0, 0.0, 1.0);
}
