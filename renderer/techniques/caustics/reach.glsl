// Where the volume between three rays may light the receiver.
#include "techniques/caustics/blocks.glsl"

layout(std430, binding = 6) readonly buffer Blocks { ivec2 blocks[]; };  // as blocks.comp.glsl finds them
uniform int slices;

vec2 least_at(float depth, vec4 a, vec4 b, vec4 c) {
  return min(min(a.xy + depth * a.zw, b.xy + depth * b.zw), c.xy + depth * c.zw);
}
vec2 most_at(float depth, vec4 a, vec4 b, vec4 c) {
  return max(max(a.xy + depth * a.zw, b.xy + depth * b.zw), c.xy + depth * c.zw);
}

// Whether some block of a map of that size may show the receiver nearest to one of these planes and touch the volume there:
// of the level of which the volume touches no more than about 8 x 8. What bounds both ends bounds all between them.
bool may_light(int first_plane, int last_plane, vec4 a, vec4 b, vec4 c, ivec2 size) {
  const float kMargin = 1.0 / 16.0;  // texels, for what OpenGL rounds corners by
  float near = (float(first_plane) - 0.5) / float(slices);
  float far = (float(last_plane) + 0.5) / float(slices);
  ivec2 count = blocks_of(size);
  vec2 low = (min(least_at(near, a, b, c), least_at(far, a, b, c)) * vec2(size) - kMargin) / float(kBlock);
  vec2 high = (max(most_at(near, a, b, c), most_at(far, a, b, c)) * vec2(size) + kMargin) / float(kBlock);
  ivec2 from = ivec2(clamp(floor(low), vec2(0.0), vec2(count)));
  ivec2 to = ivec2(clamp(floor(high), vec2(-1.0), vec2(count - 1)));
  int start = 0;
  while (max(to.x - from.x, to.y - from.y) > 8) {
    start += count.x * count.y;
    count = coarser(count);
    from >>= 1;
    to >>= 1;
  }
  for (int y = from.y; y <= to.y; ++y)
    for (int x = from.x; x <= to.x; ++x) {
      ivec2 planes = blocks[start + y * count.x + x];
      if (planes.x <= last_plane && planes.y >= first_plane) return true;
    }
  return false;
}
