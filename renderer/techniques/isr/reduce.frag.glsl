// Reduces blocks of patches to one each: what leaves them adds up, position and normal are those nearest the middle.
#include "techniques/isr/coarse.glsl"

uniform int block;

layout(location = 0) out vec4 patch_out;
layout(location = 1) out vec4 radiance_out;

void main() {
  ivec2 origin = ivec2(gl_FragCoord.xy) * block;
  ivec2 end = min(origin + block, textureSize(coarse_patches, 0));
  patch_out = vec4(0.0, 0.0, 0.0, kNoPatch);
  vec4 sum = vec4(0.0);
  ivec2 middle = origin + middle_of(block);
  int nearest = 1 << 20;
  for (int y = origin.y; y < end.y; ++y) {
    for (int x = origin.x; x < end.x; ++x) {
      vec4 other = texelFetch(coarse_patches, ivec2(x, y), 0);
      if (other.w == kNoPatch) continue;
      ivec2 off = ivec2(x, y) - middle;
      int distance2 = off.x * off.x + off.y * off.y;
      if (distance2 < nearest) {
        nearest = distance2;
        patch_out = other;
      }
      vec4 radiance = texelFetch(coarse_radiance, ivec2(x, y), 0);
      sum += vec4(radiance.rgb * radiance.a, radiance.a);
    }
  }
  radiance_out = sum.a > 0.0 ? vec4(sum.rgb / sum.a, sum.a / float(block * block)) : vec4(0.0);
}
