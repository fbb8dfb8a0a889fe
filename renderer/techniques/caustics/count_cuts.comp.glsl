// Counts the cuts of each group of triangles.
#include "shaders/compute.glsl"
#include "techniques/caustics/cut_marks.glsl"

layout(std430, binding = 3) writeonly buffer Counts { uint counts[]; };  // of each group

shared uint count_of[gl_WorkGroupSize.x];

void main() {
  count_of[gl_LocalInvocationID.x] = marked_planes(int(gl_GlobalInvocationID.x));
  barrier();
  if (gl_LocalInvocationID.x != 0u) return;
  uint sum = 0u;
  for (uint i = 0u; i < gl_WorkGroupSize.x; ++i) sum += count_of[i];
  counts[gl_WorkGroupID.x] = sum;
}
