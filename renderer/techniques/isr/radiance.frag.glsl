// What leaves the surfaces of the surround: emission, and what the albedo sends back of all that arrives. The sides that
// face the camera are in the lower half of the picture, the other sides in the upper half.
#include "shaders/gbuffer.glsl"
#include "techniques/isr/surfel.glsl"

layout(binding = 9) uniform sampler2D front_irradiance;
layout(binding = 10) uniform sampler2D back_irradiance;
#ifdef WITH_INDIRECT
// Of one texel of each block, both sides as here; alpha: what it is worth.
layout(binding = 11) uniform sampler2D indirect;
layout(binding = 12) uniform sampler2D surfels;
uniform int block;  // coarse_patches are the receivers of its blocks
// A texel takes light from those whose plane is no farther than this share of its distance from the camera.
const float kPlaneTolerance = 0.01;

// Light of a side from the four blocks around a texel, weighted by how near they are and whether they are the same
// surface.
vec3 gather_indirect(ivec2 pixel, bool back) {
  vec4 surfel = texelFetch(surfels, pixel, 0);
  vec3 position = surfel_position(tile_ray(pixel), surfel);
  vec3 normal = surfel_normal(surfel);
  ivec2 cells = textureSize(coarse_patches, 0);
  vec2 place = vec2(pixel - middle_of(block)) / float(block);
  ivec2 base = ivec2(floor(place));
  vec2 f = place - vec2(base);
  vec4 sum = vec4(0.0);
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
    vec4 light = texelFetch(indirect, ivec2(cell.x, back ? cell.y + cells.y : cell.y), 0);
    sum += weight * light.a * vec4(light.rgb, 1.0);
  }
  return sum.rgb / max(sum.a, 1e-12);
}
#endif

layout(location = 0) out vec4 radiance;

const float kLargestHalf = 65504.0;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int rows = textureSize(front_irradiance, 0).y;
  bool back = pixel.y >= rows;
  if (back) pixel.y -= rows;
  radiance = vec4(0.0);
  if (gbuffer_z(pixel) <= 0.0) return;
  vec3 emission = texelFetch(gbuffer_emission, pixel, 0).rgb;
  vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
  vec3 light = back ? texelFetch(back_irradiance, pixel, 0).rgb : texelFetch(front_irradiance, pixel, 0).rgb;
#ifdef WITH_INDIRECT
  light += albedo.a * gather_indirect(pixel, back);
#endif
  radiance.rgb = min(emission + albedo.rgb * light, kLargestHalf);
}
