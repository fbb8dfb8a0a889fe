// The smallest and largest depth with geometry over a block of pixels; empty where the smallest is larger.
#include "shaders/gbuffer.glsl"

layout(location = 0) out vec2 range;

uniform int block_size;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * block_size;
  ivec2 last = min(first + block_size, ivec2(frame_size.xy));
  range = vec2(1e30, -1e30);
  for (int y = first.y; y < last.y; ++y)
    for (int x = first.x; x < last.x; ++x) {
      float z = gbuffer_z(ivec2(x, y));
      if (z > 0.0) range = vec2(min(range.x, z), max(range.y, z));
    }
}
