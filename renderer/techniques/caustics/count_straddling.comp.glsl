// How many triangles straddle surfaces, of each run of run_length triangles.
#include "shaders/compute.glsl"
#include "techniques/caustics/states.glsl"

layout(std430, binding = 0) readonly buffer States { uint states[]; };
layout(std430, binding = 1) writeonly buffer Counts { uint counts[]; };
uniform int triangle_count;
uniform int run_length;

void main() {
  int run = int(gl_GlobalInvocationID.x);
  int first = run * run_length;
  if (first >= triangle_count) return;
  uint count = 0u;
  for (int i = first; i < min(first + run_length, triangle_count); ++i) count += uint(states[i] == kStraddles);
  counts[run] = count;
}
