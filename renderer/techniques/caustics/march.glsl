// Rays of the water that meet the surfaces of a position map.
#include "techniques/caustics/places.glsl"

layout(binding = 0) uniform sampler2D places;
uniform int steps;
uniform float tolerance;  // in depth of the box: by how much a ray may pass the surface that it hits

// The depth that the map shows at a place: between the four texels around where all show the receiver, so that slopes
// are no stairs, else the nearest's.
float shown_depth(vec2 place) {
  ivec2 size = textureSize(places, 0);
  vec2 texel = clamp(place * vec2(size), vec2(0.0), vec2(size)) - 0.5;
  vec2 part = fract(texel);
  ivec2 low = max(ivec2(floor(texel)), ivec2(0));
  ivec2 high = min(ivec2(floor(texel)) + 1, size - 1);
  vec4 a = texelFetch(places, low, 0);
  vec4 b = texelFetch(places, ivec2(high.x, low.y), 0);
  vec4 c = texelFetch(places, ivec2(low.x, high.y), 0);
  vec4 d = texelFetch(places, high, 0);
  if (shows_receiver(a) && shows_receiver(b) && shows_receiver(c) && shows_receiver(d))
    return mix(mix(a.x, b.x, part.x), mix(c.x, d.x, part.x), part.y);
  return part.y < 0.5 ? (part.x < 0.5 ? a.x : b.x) : (part.x < 0.5 ? c.x : d.x);
}

// By how much the ray is behind what the map shows where it is at that depth.
float behind(vec4 ray, float depth) { return depth - shown_depth(ray.xy + depth * ray.zw); }

bool receiver_at(vec2 place) {
  vec2 size = vec2(textureSize(places, 0));
  return shows_receiver(texelFetch(places, clamp(ivec2(floor(place * size)), ivec2(0), ivec2(size) - 1), 0));
}

// The depth at which a ray (its place in the map at depth 0, and what each unit of depth adds) lands on the receiver;
// -1 where it does not, or where the map does not tell, since it passes behind something.
float landing(vec4 ray) {
  // While it is over the map.
  float first = 0.0;
  float last = 1.0;
  for (int axis = 0; axis < 2; ++axis) {
    float at = ray[axis];
    float step = ray[axis + 2];
    if (step == 0.0) {
      if (at < 0.0 || at > 1.0) return -1.0;
      continue;
    }
    float a = -at / step;
    float b = (1.0 - at) / step;
    first = max(first, min(a, b));
    last = min(last, max(a, b));
  }
  if (first > last || behind(ray, first) > tolerance) return -1.0;
  float over = first;
  float under = -1.0;
  for (int i = 1; i <= steps; ++i) {
    float depth = mix(first, last, float(i) / float(steps));
    if (behind(ray, depth) > 0.0) {
      under = depth;
      break;
    }
    over = depth;
  }
  if (under < 0.0) return -1.0;
  for (int i = 0; i < 10; ++i) {
    float middle = 0.5 * (over + under);
    if (behind(ray, middle) > 0.0)
      under = middle;
    else
      over = middle;
  }
  if (behind(ray, under) > tolerance || !receiver_at(ray.xy + under * ray.zw)) return -1.0;
  return under;
}
