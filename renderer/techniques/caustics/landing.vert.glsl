// Triangles of the water where their corners land.
#include "techniques/caustics/lights.glsl"

layout(std430, binding = 1) readonly buffer Hits { vec4 hits[]; };
layout(std430, binding = 2) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 3) readonly buffer Lights { vec2 lights[]; };
layout(std430, binding = 5) readonly buffer Spots { vec2 spots[]; };

layout(location = 0) out float way;
layout(location = 1) out float depth;
layout(location = 2) flat out int triangle_number;
layout(location = 3) out vec2 spot;
layout(location = 4) flat out vec2 edges[2];  // of the image, in the map

void main() {
  triangle_number = gl_VertexID / 3;
  way = depth = 0.0;
  edges[0] = edges[1] = spot = vec2(0.0);
  gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // nowhere
  if (lights[triangle_number] != kLands) return;
  vec4 p = hits[corners[3 * triangle_number]];
  edges[0] = hits[corners[3 * triangle_number + 1]].xy - p.xy;
  edges[1] = hits[corners[3 * triangle_number + 2]].xy - p.xy;
  vec4 hit = hits[corners[gl_VertexID]];
  depth = hit.z;
  way = hit.w;
  spot = spots[corners[gl_VertexID]];
  gl_Position = vec4(2.0 * hit.xy - 1.0, 0.0, 1.0);
}
