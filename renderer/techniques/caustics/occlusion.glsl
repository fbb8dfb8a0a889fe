// What stands beside the way of a ray, by the first two surfaces of each texel (renderer/caustics/occluder_map.h).
#include "techniques/caustics/places.glsl"

layout(binding = 2) uniform sampler2D exits;
layout(binding = 3) uniform sampler2D ceilings;
uniform int occluder_block;  // texels along an edge of those that a texel of `ceilings` stands for
uniform int march_steps;

// Whether something stops a ray on its way to the surface in the middle of a texel, whose place this is. The ray is followed
// from there towards the light, past what the map shows between a texel's surface and where its solid ends.
bool is_occluded(sampler2D places, ivec2 texel, vec4 place, vec2 ray_step) {
  const float kTolerance = 1e-3;  // in depth of the box, by which a ray may be behind a surface that it only touches
  float rise = place.x - texelFetch(ceilings, texel / occluder_block, 0).r;
  if (rise <= 0.0) return false;
  ivec2 size = textureSize(places, 0);
  vec2 texels_of_depth = ray_step * vec2(size);
  vec2 way = abs(rise * texels_of_depth);
  int count = clamp(int(ceil(max(way.x, way.y))), 1, march_steps);
  float step = rise / float(count);
  for (int i = 1; i <= count; ++i) {
    float above = float(i) * step;
    vec2 at = vec2(texel) + 0.5 - above * texels_of_depth;
    ivec2 over = ivec2(floor(at));
    if (any(lessThan(over, ivec2(0))) || any(greaterThanEqual(over, size))) return false;
    vec4 surface = texelFetch(places, over, 0);
    precise float behind = place.x - above - (surface.x + dot(surface.zw, (at - vec2(over) - 0.5) / vec2(size)));
    // As far behind a sheet as one step brings the ray, so that one of them finds that it passes through.
    precise float sheet = kTolerance + 1.001 * step * max(tilt_factor(ray_step, surface), 1.0);
    if (behind > kTolerance && behind < max(texelFetch(exits, over, 0).r - surface.x, sheet)) return true;
  }
  return false;
}
