// Over a block of patches: x: sum of their distances to the power of -exponent; y: how many there are.
#include "techniques/isr/coarse.glsl"

uniform int block;
uniform float exponent;

layout(location = 0) out vec2 sum;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * block;
  ivec2 last = min(first + block, textureSize(coarse_patches, 0));
  sum = vec2(0.0);
  for (int y = first.y; y < last.y; ++y)
    for (int x = first.x; x < last.x; ++x) {
      vec4 patch_ = texelFetch(coarse_patches, ivec2(x, y), 0);
      if (patch_.w != kNoPatch) sum += vec2(pow(length(patch_.xyz), -exponent), 1.0);
    }
}
