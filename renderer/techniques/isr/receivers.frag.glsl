// Which texel of each block of the surround receives light for it: one that shows a surface, nearest the block's middle.
#include "shaders/frame.glsl"
#include "shaders/tiles.glsl"
#include "techniques/isr/surfel.glsl"

layout(binding = 9) uniform sampler2D surfels;
uniform int block;

layout(location = 0) out vec4 receiver;  // as coarse_patches, along the eye axes

void main() {
  ivec2 origin = ivec2(gl_FragCoord.xy) * block;
  ivec2 end = min(origin + block, textureSize(surfels, 0));
  ivec2 middle = origin + middle_of(block);
  int nearest = 1 << 20;
  receiver = vec4(0.0, 0.0, 0.0, kNoPatch);
  for (int y = origin.y; y < end.y; ++y) {
    for (int x = origin.x; x < end.x; ++x) {
      vec4 surfel = texelFetch(surfels, ivec2(x, y), 0);
      ivec2 off = ivec2(x, y) - middle;
      int distance2 = off.x * off.x + off.y * off.y;
      if (!is_surface(surfel) || distance2 >= nearest) continue;
      nearest = distance2;
      receiver = vec4(surfel_position(tile_ray(ivec2(x, y)), surfel), pack_normal(surfel_normal(surfel)));
    }
  }
}
