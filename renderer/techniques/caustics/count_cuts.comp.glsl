// How many cuts each group of triangles has.
#include "shaders/compute.glsl"

layout(std430, binding = 2) readonly buffer Marks { uint marks[]; };
layout(std430, binding = 3) writeonly buffer Counts { uint counts[]; };  // of each group
uniform int listed;  // triangles
uniform int words;   // for each

shared uint count_of[gl_WorkGroupSize.x];

void main() {
  int number = int(gl_GlobalInvocationID.x);
  uint count = 0u;
  if (number < listed)
    for (int word = 0; word < words; ++word) count += uint(bitCount(marks[number * words + word]));
  count_of[gl_LocalInvocationID.x] = count;
  barrier();
  if (gl_LocalInvocationID.x != 0u) return;
  uint sum = 0u;
  for (uint i = 0u; i < gl_WorkGroupSize.x; ++i) sum += count_of[i];
  counts[gl_WorkGroupID.x] = sum;
}
