// Lists the cuts that are marked, in the order of the triangles: so that the light in a texel is summed in one order whichever
// planes are drawn.
#include "shaders/compute.glsl"
#include "techniques/caustics/cut_marks.glsl"
#include "techniques/caustics/cuts.glsl"

layout(std430, binding = 3) readonly buffer Counts { uint counts[]; };  // before each group
layout(std430, binding = 4) writeonly buffer Cuts { uint cuts[]; };

shared uint count_of[gl_WorkGroupSize.x];

void main() {
  int number = int(gl_GlobalInvocationID.x);
  count_of[gl_LocalInvocationID.x] = marked_planes(number);
  barrier();
  if (number >= listed) return;
  uint place = counts[gl_WorkGroupID.x];
  for (uint i = 0u; i < gl_LocalInvocationID.x; ++i) place += count_of[i];
  for (int word = 0; word < words; ++word)
    for (uint left = marks[number * words + word]; left != 0u; left &= left - 1u)
      cuts[place++] = cut_of(uint(number), 32 * word + findLSB(left));
}
