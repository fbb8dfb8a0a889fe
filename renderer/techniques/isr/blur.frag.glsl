// One direction of a separable blur. The bilateral kind takes light only from patches near the tangent plane and with a
// like normal, so that nothing leaks round edges.
#include "techniques/isr/coarse.glsl"

layout(binding = 9) uniform sampler2D indirect_in;
layout(binding = 10) uniform sampler2D cover_in;

uniform ivec2 direction;
uniform int radius;
uniform ivec2 coarse_size;
uniform float falloff;          // of the Gaussian: 1 / (2 sigma^2)
uniform float plane_tolerance;  // distance from the tangent plane, in units of z, where a weight is 1/e

layout(location = 0) out vec4 indirect;
#ifdef OCCLUSION
layout(location = 1) out vec2 cover;
#endif

void main() {
  indirect = vec4(0.0);
#ifdef OCCLUSION
  cover = vec2(1.0, 0.0);
  vec2 cover_sum = vec2(0.0);
#endif
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 center = texelFetch(coarse_patches, pixel, 0);
  if (center.w == kNoPatch) return;
#ifdef BLUR_BILATERAL
  vec3 normal = unpack_normal(center.w);
  vec3 plane = normal / (plane_tolerance * eye_z(center.xyz));
#endif
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (int i = -radius; i <= radius; ++i) {
    ivec2 at = pixel + i * direction;
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, coarse_size))) continue;
    vec4 other = texelFetch(coarse_patches, at, 0);
    if (other.w == kNoPatch) continue;
    float exponent = float(i * i) * falloff;
#ifdef BLUR_BILATERAL
    float off_plane = dot(plane, other.xyz - center.xyz);
    float likeness = max(dot(normal, unpack_normal(other.w)), 0.0);
    likeness *= likeness;
    likeness *= likeness;
    float weight = exp(-exponent - off_plane * off_plane) * likeness * likeness;
#else
    float weight = exp(-exponent);
#endif
    sum += weight * texelFetch(indirect_in, at, 0);
#ifdef OCCLUSION
    cover_sum += weight * texelFetch(cover_in, at, 0).xy;
#endif
    weights += weight;
  }
  indirect = sum / weights;  // the centre's own weight is 1
#ifdef OCCLUSION
  cover = cover_sum / weights;
#endif
}
