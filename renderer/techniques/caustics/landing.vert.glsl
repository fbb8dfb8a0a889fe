// Triangles of the water where their corners land.
#include "techniques/caustics/lights.glsl"
#include "techniques/caustics/triangles.glsl"

layout(std430, binding = 1) readonly buffer Hits { vec4 hits[]; };
layout(std430, binding = 2) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 3) readonly buffer Lights { vec2 lights[]; };
layout(std430, binding = 5) readonly buffer Spots { vec2 spots[]; };

layout(location = 0) out float way;
layout(location = 1) out float depth;
layout(location = 2) out vec2 spot;
layout(location = 3) flat out vec3 flux;
layout(location = 4) flat out float area;  // of the image

uniform float map_area;

void main() {
  int triangle_number = gl_VertexID / 3;
  way = depth = area = 0.0;
  spot = vec2(0.0);
  flux = vec3(0.0);
  gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // nowhere
  if (lights[triangle_number] != kLands) return;
  vec4 p = hits[corners[3 * triangle_number]];
  vec2 pq = hits[corners[3 * triangle_number + 1]].xy - p.xy;
  vec2 pr = hits[corners[3 * triangle_number + 2]].xy - p.xy;
  area = 0.5 * map_area * abs(pq.x * pr.y - pq.y * pr.x);
  flux = triangles[triangle_number].flux.rgb;
  vec4 hit = hits[corners[gl_VertexID]];
  depth = hit.z;
  way = hit.w;
  spot = spots[corners[gl_VertexID]];
  gl_Position = vec4(2.0 * hit.xy - 1.0, 0.0, 1.0);
}
