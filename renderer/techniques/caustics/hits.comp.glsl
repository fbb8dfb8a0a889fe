// Where the refracted rays of the water's vertices land.
#include "shaders/compute.glsl"
#include "techniques/caustics/march.glsl"

layout(std430, binding = 0) readonly buffer Rays { vec4 rays[]; };
layout(std430, binding = 1) readonly buffer Ways { vec2 ways[]; };
layout(std430, binding = 2) writeonly buffer Hits { vec4 hits[]; };  // place in the map, depth, way; way 0: none
uniform int ray_count;

void main() {
  int number = int(gl_GlobalInvocationID.x);
  if (number >= ray_count) return;
  vec4 ray = rays[number];
  float depth = landing(ray);
  float way = ways[number].x + depth * ways[number].y;
  hits[number] = depth < 0.0 || way <= 0.0 ? vec4(0.0) : vec4(ray.xy + depth * ray.zw, depth, way);
}
