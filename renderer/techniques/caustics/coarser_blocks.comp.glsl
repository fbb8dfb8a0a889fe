// Between which planes the receiver lies in each block of one level, from those of the level before: an invocation for each.
#include "shaders/compute.glsl"
#include "techniques/caustics/blocks.glsl"

layout(std430, binding = 0) buffer Blocks { ivec2 blocks[]; };
uniform ivec2 finer;      // how many blocks the level before has
uniform int first_finer;  // where they begin
uniform int first;

void main() {
  ivec2 count = coarser(finer);
  int number = int(gl_GlobalInvocationID.x);
  if (number >= count.x * count.y) return;
  ivec2 from = 2 * ivec2(number % count.x, number / count.x);
  ivec2 end = min(from + 2, finer);
  ivec2 planes = kNoPlanes;
  for (int y = from.y; y < end.y; ++y)
    for (int x = from.x; x < end.x; ++x) {
      ivec2 part = blocks[first_finer + y * finer.x + x];
      planes = ivec2(min(planes.x, part.x), max(planes.y, part.y));
    }
  blocks[first + number] = planes;
}
