// Bilateral upsampling (eq. 27 and 28) and the final light (eq. 29).
#include "shaders/gbuffer.glsl"
#include "techniques/isr/coarse.glsl"

layout(binding = 8) uniform sampler2D coarse_depths;  // eye-space z of the patches, 0 where there is none
layout(binding = 9) uniform sampler2D indirect_in;
layout(binding = 10) uniform sampler2D cover_in;  // openness; the share of directions that surfaces cover
layout(binding = 11) uniform sampler2D lit;

uniform int block;
uniform ivec2 coarse_size;
uniform float depth_epsilon;  // in units of z
#ifndef UPSAMPLING_DEPTH
uniform float depth_tolerance;  // in units of z: beyond it a patch does not fit
#endif
uniform float k_isr;
uniform float k_ssao;

layout(location = 0) out vec4 image;
#ifdef KEEP_BUFFERS
layout(location = 1) out vec4 indirect_out;
layout(location = 2) out vec3 shares_out;  // openness, covered, unknown
#endif

// In the order of textureGather.
const vec4 kCornerX = vec4(0.0, 1.0, 1.0, 0.0);
const vec4 kCornerY = vec4(1.0, 1.0, 0.0, 0.0);

#ifdef UPSAMPLING_DEPTH
// Eq. 27. A patch always weighs something, however far it is; one that shows no object weighs nothing.
vec4 weights_by_depth(vec4 bilinear, vec4 depths, float z) {
  vec4 difference = abs(depths / z - 1.0);
  return bilinear / (depth_epsilon + difference) * vec4(greaterThan(depths, vec4(0.0)));
}
#else
// Depths are compared along the pixel's tangent plane, so that a slanted surface fits itself. What does not fit does not
// count; where nothing does, the nearest counts alone.
vec4 weights_by_plane(vec4 bilinear, vec4 depths, ivec2 pixel, float z, vec2 f) {
  vec3 normal = gbuffer_geometric_normal(pixel);
  float here = dot(normal, unit_ray((vec2(pixel) + 0.5) * frame_size.zw));
  vec2 slope = vec2(dot(normal, far_u.xyz), dot(normal, far_v.xyz)) * frame_size.zw * float(block) / camera_position.w;
  vec4 there = here + (kCornerX - f.x) * slope.x + (kCornerY - f.y) * slope.y;
  // Where the plane is nearly seen from its edge it says nothing about depth.
  vec4 expected = mix(vec4(1.0), clamp(here / there, 0.5, 2.0), greaterThan(there * here, vec4(0.01 * here * here)));
  vec4 difference = mix(vec4(1e30), abs(depths / z - expected), greaterThan(depths, vec4(0.0)));
  vec4 weight = bilinear / (depth_epsilon + difference) * vec4(lessThanEqual(difference, vec4(depth_tolerance)));
  if (dot(weight, vec4(1.0)) > 0.0) return weight;
  float nearest = min(min(difference.x, difference.y), min(difference.z, difference.w));
  return vec4(lessThanEqual(difference, vec4(nearest)));
}
#endif

// Light and cover at a pixel from the four patches around it.
void upsample(ivec2 pixel, float z, out vec4 indirect, out vec2 cover) {
  vec2 from_patch = vec2(pixel) - patch_place(block);
  ivec2 base = ivec2(floor(from_patch / float(block)));
  vec2 f = (from_patch - vec2(base * block)) / float(block);
  vec4 depths = textureGather(coarse_depths, vec2(base + 1) / vec2(coarse_size));
  vec4 bilinear = mix(vec4(1.0 - f.x), vec4(f.x), kCornerX) * mix(vec4(1.0 - f.y), vec4(f.y), kCornerY);
#ifdef UPSAMPLING_DEPTH
  vec4 weight = weights_by_depth(bilinear, depths, z);
#else
  vec4 weight = weights_by_plane(bilinear, depths, pixel, z, f);
#endif
  weight /= dot(weight, vec4(1.0));  // eq. 28

  indirect = vec4(0.0);
  cover = vec2(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 at = clamp(base + ivec2(kCornerX[i], kCornerY[i]), ivec2(0), coarse_size - 1);
    indirect += weight[i] * texelFetch(indirect_in, at, 0);
#ifdef OCCLUSION
    cover += weight[i] * texelFetch(cover_in, at, 0).xy;
#endif
  }
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float z = gbuffer_z(pixel) * camera_position.w;
#ifdef KEEP_BUFFERS
  indirect_out = vec4(0.0);
  shares_out = vec3(1.0, 0.0, 0.0);
#endif
#ifdef INDIRECT_ONLY
  image = vec4(0.0);
#else
  image = texelFetch(lit, pixel, 0);
#endif
  if (z <= 0.0) return;

  vec4 gathered;
  vec2 cover;
  upsample(pixel, z, gathered, cover);
  vec3 indirect = gathered.rgb;
#ifdef ENERGY_BOUND
  indirect /= max(gathered.a, 1.0);  // a full hemisphere of form factors adds up to 1
#endif
#ifdef WEIGHTING_AREA
  vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
  indirect *= albedo.rgb * albedo.a;
#endif
  indirect *= k_isr;
#if defined(OCCLUSION) && !defined(INDIRECT_ONLY)
  vec3 emission = texelFetch(gbuffer_emission, pixel, 0).rgb;
  image.rgb = emission + (image.rgb - emission) * clamp(cover.x + 1.0 - k_ssao, 0.0, 1.0);
#endif
  image = vec4(image.rgb + indirect, 1.0);
#ifdef KEEP_BUFFERS
  indirect_out = vec4(indirect, 1.0);
  shares_out = vec3(cover, 1.0 - min(gathered.a, 1.0));
#endif
}
