// Between which planes the receiver lies in each block of a position map: an invocation for each.
#include "shaders/compute.glsl"
#include "techniques/caustics/blocks.glsl"
#include "techniques/caustics/planes.glsl"

layout(binding = 0) uniform sampler2D places;
layout(std430, binding = 0) writeonly buffer Blocks { ivec2 blocks[]; };
uniform float slices;

void main() {
  ivec2 size = textureSize(places, 0);
  ivec2 count = blocks_of(size);
  int number = int(gl_GlobalInvocationID.x);
  if (number >= count.x * count.y) return;
  ivec2 first = kBlock * ivec2(number % count.x, number / count.x);
  ivec2 end = min(first + kBlock, size);
  vec2 depths = vec2(2.0, -1.0);
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x) {
      vec4 place = texelFetch(places, ivec2(x, y), 0);
      if (shows_receiver(place)) depths = vec2(min(depths.x, place.x), max(depths.y, place.x));
    }
  blocks[number] = depths.x > depths.y ? kNoPlanes : ivec2(nearest_plane(depths.x, slices), nearest_plane(depths.y, slices));
}
