// Where each group's cuts begin in their list, and that all are drawn: the first invocation does it all.
#include "shaders/compute.glsl"
#include "techniques/caustics/draw_volumes.glsl"

layout(std430, binding = 3) buffer Counts { uint counts[]; };  // of each group; then what those before it have
uniform int groups;

void main() {
  if (gl_GlobalInvocationID.x != 0u) return;
  uint before = 0u;
  for (int group = 0; group < groups; ++group) {
    uint count = counts[group];
    counts[group] = before;
    before += count;
  }
  index_count = 3u * before;
}
