// Gathers indirect light, and optionally occlusion, for each patch from the patches around it on the screen.
#include "techniques/isr/coarse.glsl"
#include "techniques/isr/dither.glsl"
#include "techniques/isr/samples_share.glsl"

const int kMaxSamples = 1000;  // also in isr_kernel.h
const int kMaxLevels = 5;      // also in isr_samples.h

// xy: offset in patches; z: the share of the kernel that the sample stands for, as an area on the image plane at
// distance 1, divided by pi.
layout(std140, binding = 1) uniform Kernel {
  vec4 kernel[kMaxSamples];
  // Kernels of 1/4 to 4 times the samples where these go by depth, else one: the first sample, the first that reads larger
  // blocks, and the end.
  ivec4 levels[kMaxLevels];
};

layout(binding = 8) uniform sampler2D coarse_normals;  // shading normals, octahedral
// The same picture in larger blocks, for samples that stand for more than a block: it stays in the cache.
layout(binding = 9) uniform sampler2D far_patches;
layout(binding = 10) uniform sampler2D far_radiance;

#ifdef SAMPLES_BY_DEPTH
uniform float depth_exponent;
uniform float depth_scale;  // makes the mean of the samples what it would be
#endif
uniform float form_factor_limit;
uniform vec2 coarse_texel;  // of the picture, 0..1
uniform vec3 background;
uniform float occluder_radius;  // at distance 1
uniform float occlusion_scale;  // of the kernel

layout(location = 0) out vec4 indirect;  // light of a white surface; alpha: sum of the form factors
#ifdef OCCLUSION
layout(location = 1) out vec2 cover;  // openness; 0, since visibility is not known
#endif

const float kTwoPi = 6.28318530718;
const float kSmallestSquare = 1e-30;

// How the kernel is turned, and scaled, at a patch: a complex factor of its offsets.
vec2 kernel_turn(ivec2 pixel) {
#if defined(ROTATION_RANDOM)
  float angle = float(pixel_hash(pixel) >> 8) * (kTwoPi / 16777216.0);
  return vec2(cos(angle), sin(angle));
#elif defined(ROTATION_TILED)
  uint n = tiled_order(pixel);
  float angle = float(n) * (kTwoPi / 64.0);
  float scale = 1.0 + 0.08 * (fract(float(n) * 0.61803399) - 0.5);
  return scale * vec2(cos(angle), sin(angle));
#else
  return vec2(1.0, 0.0);
#endif
}

// What the samples first..end-1 see. They read patches of `block` by `block` pixels of this picture.
vec4 gather_samples(int first, int end, sampler2D patches, sampler2D radiances, int block, vec3 position,
                    vec3 normal, vec2 turn) {
  vec4 sum = vec4(0.0);
  float plane_area = dot(turn, turn);
  vec2 center = (floor(gl_FragCoord.xy) + 0.5) / float(block);
  vec2 step_x = turn / float(block);
  vec2 step_y = vec2(-step_x.y, step_x.x);
  ivec2 size = textureSize(patches, 0);
  for (int i = first; i < end; ++i) {
    vec4 k = kernel[i];
    ivec2 at = ivec2(floor(center + k.x * step_x + k.y * step_y));
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
    vec4 other = texelFetch(patches, at, 0);
    float share = k.z * plane_area;
#ifdef BACKGROUND
    // Nothing stands on the ray through such a pixel: a surface facing its direction sees the background there.
    if (other.w == kNoPatch) {
      vec3 ray = unit_ray((vec2(at) + 0.5) * float(block) * coarse_texel);
      float length2 = dot(ray, ray);
      float form_factor = max(dot(normal, ray), 0.0) * share / (length2 * length2);
      sum += form_factor * vec4(background, 1.0);
      continue;
    }
#else
    if (other.w == kNoPatch) continue;
#endif
    vec3 to = other.xyz - position;
    float r2 = dot(to, to);
    float facing = dot(normal, to);
    if (facing <= 0.0 || r2 < kSmallestSquare) continue;
    float z = eye_z(other.xyz);
    float leaving = -dot(unpack_normal(other.w), to);
    if (leaving <= 0.0) continue;
    vec4 radiance = texelFetch(radiances, at, 0);
    float cosines = (facing / r2) * leaving;
    float area = share * z * z;  // divided by pi
#ifdef WEIGHTING_AREA
    area *= radiance.a;
#endif
#ifdef FORM_FACTOR_DISC
    float form_factor = cosines * area / (r2 + area);
#else
    float form_factor = cosines * area / r2;
#endif
    form_factor = min(form_factor, form_factor_limit);
    sum += form_factor * vec4(radiance.rgb, 1.0);
  }
  return sum;
}

#ifdef OCCLUSION
// Eq. 26 over the same kernel made smaller: distant spheres of a pixel's size occlude nothing.
float occlusion(ivec4 level, vec3 position, vec3 normal, vec2 turn) {
  vec2 center = floor(gl_FragCoord.xy) + 0.5;
  vec2 step_x = turn * occlusion_scale;
  vec2 step_y = vec2(-step_x.y, step_x.x);
  ivec2 size = textureSize(coarse_patches, 0);
  float sum = 0.0;
  for (int i = level.x; i < level.z; ++i) {
    ivec2 at = ivec2(floor(center + kernel[i].x * step_x + kernel[i].y * step_y));
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) continue;
    vec4 other = texelFetch(coarse_patches, at, 0);
    if (other.w == kNoPatch) continue;
    vec3 to = other.xyz - position;
    float r2 = dot(to, to);
    float facing = dot(normal, to);
    if (facing <= 0.0 || r2 < kSmallestSquare) continue;
    float r = occluder_radius * eye_z(other.xyz);
    // The root's argument is negative inside the sphere.
    sum += (1.0 - sqrt(max(1.0 - r * r / r2, 0.0))) * facing * inversesqrt(r2);
  }
  return min(sum * kTwoPi / float(level.z - level.x), 1.0);
}
#endif

void main() {
  indirect = vec4(0.0);
#ifdef OCCLUSION
  cover = vec2(1.0, 0.0);
#endif
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 receiver = texelFetch(coarse_patches, pixel, 0);
  if (receiver.w == kNoPatch) return;
  vec3 normal = decode_octahedral(texelFetch(coarse_normals, pixel, 0).xy);
  vec2 turn = kernel_turn(pixel);
  ivec4 level = levels[0];
#ifdef SAMPLES_BY_DEPTH
  float share = samples_share(length(receiver.xyz), depth_exponent, depth_scale);
  level = levels[int(round(log2(share * kMostSamples)))];
#endif
  indirect = gather_samples(level.x, level.y, coarse_patches, coarse_radiance, 1, receiver.xyz, normal, turn);
#ifdef FAR_BLOCK
  indirect += gather_samples(level.y, level.z, far_patches, far_radiance, FAR_BLOCK, receiver.xyz, normal, turn);
#endif
#ifdef WEIGHTING_PAPER
  indirect *= kTwoPi / float(level.z - level.x) * texelFetch(coarse_radiance, pixel, 0).a;
#endif
#ifdef OCCLUSION
  cover.x = 1.0 - occlusion(level, receiver.xyz, normal, turn);
#endif
}
