// For each block of texels of a position map, the least depth of any surface and the greatest of the receiver.
#include "techniques/caustics/places.glsl"

uniform int occluder_block;  // texels along an edge of a block
layout(binding = 0) uniform sampler2D places;

layout(location = 0) out vec2 depths;

void main() {
  ivec2 first = occluder_block * ivec2(gl_FragCoord.xy);
  ivec2 end = min(first + occluder_block, textureSize(places, 0));
  depths = vec2(2.0, -1e30);
  for (int y = first.y; y < end.y; ++y)
    for (int x = first.x; x < end.x; ++x) {
      vec4 place = texelFetch(places, ivec2(x, y), 0);
      depths.x = min(depths.x, place.x);
      if (shows_receiver(place)) depths.y = max(depths.y, place.x);
    }
}
