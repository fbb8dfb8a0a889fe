// Irradiance summed over the pixels of a block that show an object, and their number.
#include "shaders/gbuffer.glsl"

layout(binding = 8) uniform sampler2D irradiance;
layout(location = 0) out vec4 sum;

uniform int block_size;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * block_size;
  ivec2 last = min(first + block_size, ivec2(frame_size.xy));
  sum = vec4(0.0);
  for (int y = first.y; y < last.y; ++y)
    for (int x = first.x; x < last.x; ++x)
      if (gbuffer_z(ivec2(x, y)) > 0.0) sum += vec4(texelFetch(irradiance, ivec2(x, y), 0).rgb, 1.0);
}
