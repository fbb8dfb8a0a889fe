// What leaves both sides of each surface of the surround: emission, and what the albedo sends back of all that arrives.
#include "shaders/gbuffer.glsl"
#include "techniques/isr/surfel.glsl"

layout(binding = 9) uniform sampler2D front_irradiance;
layout(binding = 10) uniform sampler2D back_irradiance;
#ifdef WITH_INDIRECT
// Of one texel of each block; alpha: what it is worth.
layout(binding = 11) uniform sampler2D front_indirect;
layout(binding = 12) uniform sampler2D back_indirect;
layout(binding = 13) uniform sampler2D surfels;
uniform int block;  // coarse_patches are the receivers of its blocks
// A texel takes light from those whose plane is no farther than this share of its distance from the camera.
const float kPlaneTolerance = 0.01;

// Light of both sides from the four blocks around a texel, weighted by how near they are and whether they are the same
// surface.
void gather_indirect(ivec2 pixel, vec3 position, vec3 normal, out vec3 to_front, out vec3 to_back) {
  ivec2 cells = textureSize(front_indirect, 0);
  vec2 place = vec2(pixel - middle_of(block)) / float(block);
  ivec2 base = ivec2(floor(place));
  vec2 f = place - vec2(base);
  vec4 front_sum = vec4(0.0);
  vec4 back_sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    ivec2 cell = clamp(base + corner, ivec2(0), cells - 1);
    vec4 receiver = texelFetch(coarse_patches, cell, 0);
    if (receiver.w == kNoPatch) continue;
    vec3 other = unpack_normal(receiver.w);
    float height = dot(other, position - receiver.xyz);
    bool same = abs(height) < kPlaneTolerance * length(position) && dot(other, normal) > 0.8;
    vec2 near = mix(1.0 - f, f, vec2(corner));
    float weight = (near.x * near.y + 1e-3) * (same ? 1.0 : 1e-4);
    vec4 front_light = texelFetch(front_indirect, cell, 0);
    vec4 back_light = texelFetch(back_indirect, cell, 0);
    front_sum += weight * front_light.a * vec4(front_light.rgb, 1.0);
    back_sum += weight * back_light.a * vec4(back_light.rgb, 1.0);
  }
  to_front = front_sum.rgb / max(front_sum.a, 1e-12);
  to_back = back_sum.rgb / max(back_sum.a, 1e-12);
}
#endif

layout(location = 0) out vec4 front;
layout(location = 1) out vec4 back;

const float kLargestHalf = 65504.0;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  front = vec4(0.0);
  back = vec4(0.0);
  if (gbuffer_z(pixel) <= 0.0) return;
  vec3 emission = texelFetch(gbuffer_emission, pixel, 0).rgb;
  vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
  vec3 to_front = texelFetch(front_irradiance, pixel, 0).rgb;
  vec3 to_back = texelFetch(back_irradiance, pixel, 0).rgb;
#ifdef WITH_INDIRECT
  vec3 surfel = texelFetch(surfels, pixel, 0).xyz;
  vec3 front_light, back_light;
  gather_indirect(pixel, surfel_position(tile_ray(pixel), surfel), unpack_normal(surfel.x), front_light, back_light);
  to_front += albedo.a * front_light;
  to_back += albedo.a * back_light;
#endif
  front.rgb = min(emission + albedo.rgb * to_front, kLargestHalf);
  back.rgb = min(emission + albedo.rgb * to_back, kLargestHalf);
}
