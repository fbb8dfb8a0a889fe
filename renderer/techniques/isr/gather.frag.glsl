// Gathers indirect light, and optionally occlusion, for each patch from the patches around it on the screen.
#include "techniques/isr/coarse.glsl"

const int kMaxSamples = 1024;  // also in isr_kernel.h

// xy: offset in patches; z: the share of the kernel that the sample stands for, as an area on the image plane at
// distance 1, divided by pi.
layout(std140, binding = 1) uniform Kernel { vec4 kernel[kMaxSamples]; };

uniform int sample_count;
uniform ivec2 coarse_size;
uniform float form_factor_limit;
uniform vec2 coarse_texel;  // of the picture, 0..1
uniform vec3 background;
uniform float occluder_radius;  // at distance 1

layout(location = 0) out vec4 indirect;  // light of a white surface; alpha: sum of the form factors
#ifdef OCCLUSION
layout(location = 1) out float openness;
#endif

const float kTwoPi = 6.28318530718;
const float kSmallestSquare = 1e-30;

// Cosine and sine of the angle that the kernel is turned by at a patch.
vec2 kernel_turn(ivec2 pixel) {
#if defined(ROTATION_RANDOM)
  uint h = uint(pixel.x) * 0x8da6b343u + uint(pixel.y) * 0xd8163841u;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  h = (h ^ (h >> 12)) * 0x297a2d39u;
  h ^= h >> 15;
  float angle = float(h >> 8) * (kTwoPi / 16777216.0);
  return vec2(cos(angle), sin(angle));
#elif defined(ROTATION_TILED)
  const int order[16] = int[](0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5);
  float angle = float(order[(pixel.y & 3) * 4 + (pixel.x & 3)]) * (kTwoPi / 16.0);
  return vec2(cos(angle), sin(angle));
#else
  return vec2(1.0, 0.0);
#endif
}

void main() {
  indirect = vec4(0.0);
#ifdef OCCLUSION
  openness = 1.0;
  float occlusion = 0.0;
#endif
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 receiver = texelFetch(coarse_patches, pixel, 0);
  if (receiver.w == kNoPatch) return;
  vec3 normal = decode_octahedral(texelFetch(coarse_normals, pixel, 0).xy);
  vec2 turn = kernel_turn(pixel);
  vec2 center = vec2(pixel) + 0.5;

  for (int i = 0; i < sample_count; ++i) {
    vec4 k = kernel[i];
    ivec2 at = ivec2(floor(center + vec2(turn.x * k.x - turn.y * k.y, turn.y * k.x + turn.x * k.y)));
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, coarse_size))) continue;
    vec4 other = texelFetch(coarse_patches, at, 0);
#ifdef BACKGROUND
    // Nothing stands on the ray through such a pixel: a surface facing its direction sees the background there.
    if (other.w == kNoPatch) {
      vec3 ray = unit_ray((vec2(at) + 0.5) * coarse_texel);
      float length2 = dot(ray, ray);
      float form_factor = max(dot(normal, ray), 0.0) * k.z / (length2 * length2);
      indirect += form_factor * vec4(background, 1.0);
      continue;
    }
#else
    if (other.w == kNoPatch) continue;
#endif
    vec3 to = other.xyz - receiver.xyz;
    float r2 = dot(to, to);
    float facing = dot(normal, to);
    if (facing <= 0.0 || r2 < kSmallestSquare) continue;
    float z = eye_z(other.xyz);
#ifdef OCCLUSION
    // Eq. 26; the argument of the root is negative inside the occluder.
    float r = occluder_radius * z;
    occlusion += (1.0 - sqrt(max(1.0 - r * r / r2, 0.0))) * facing * inversesqrt(r2);
#endif
    float leaving = -dot(unpack_normal(other.w), to);
    if (leaving <= 0.0) continue;
    vec4 radiance = texelFetch(coarse_radiance, at, 0);
    float cosines = (facing / r2) * leaving;
    float area = k.z * z * z;  // divided by pi
#ifdef WEIGHTING_AREA
    area *= radiance.a;
#endif
#ifdef FORM_FACTOR_DISC
    float form_factor = cosines * area / (r2 + area);
#else
    float form_factor = cosines * area / r2;
#endif
    form_factor = min(form_factor, form_factor_limit);
    indirect += form_factor * vec4(radiance.rgb, 1.0);
  }
#ifdef WEIGHTING_PAPER
  indirect *= kTwoPi / float(sample_count) * texelFetch(coarse_radiance, pixel, 0).a;
#endif
#ifdef OCCLUSION
  openness = 1.0 - min(occlusion * kTwoPi / float(sample_count), 1.0);
#endif
}
