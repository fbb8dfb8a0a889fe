// Bilateral upsampling (eq. 27 and 28) and the final light (eq. 29).
#include "shaders/gbuffer.glsl"
#include "techniques/isr/coarse.glsl"

layout(binding = 8) uniform sampler2D coarse_depths;  // eye-space z of the patches, 0 where there is none
layout(binding = 9) uniform sampler2D indirect_in;
layout(binding = 10) uniform sampler2D cover_in;  // openness; the share of directions that surfaces cover
layout(binding = 11) uniform sampler2D lit;

uniform int block;
uniform ivec2 coarse_size;
uniform float depth_epsilon;    // in units of z
uniform float depth_tolerance;  // in units of z: beyond it a patch does not fit
uniform float k_isr;
uniform float k_ssao;

layout(location = 0) out vec4 image;
#ifdef KEEP_BUFFERS
layout(location = 1) out vec4 indirect_out;
layout(location = 2) out vec3 shares_out;  // openness, covered, unknown
#endif

// Light and cover at a pixel from the four patches around it, which stand for the pixel in the middle of their block.
// Depths are compared along the pixel's tangent plane, so that a slanted surface fits itself.
void upsample(ivec2 pixel, float z, out vec4 indirect, out vec2 cover) {
  ivec2 from_middle = pixel - middle_of(block);
  ivec2 base = ivec2(floor(vec2(from_middle) / float(block)));
  vec2 f = vec2(from_middle - base * block) / float(block);
  // In the order of textureGather.
  const vec4 corner_x = vec4(0.0, 1.0, 1.0, 0.0);
  const vec4 corner_y = vec4(1.0, 1.0, 0.0, 0.0);
  vec4 depths = textureGather(coarse_depths, vec2(base + 1) / vec2(coarse_size));

  vec3 normal = gbuffer_geometric_normal(pixel);
  float here = dot(normal, unit_ray((vec2(pixel) + 0.5) * frame_size.zw));
  vec2 slope = vec2(dot(normal, far_u.xyz), dot(normal, far_v.xyz)) * frame_size.zw * float(block) / camera_position.w;
  vec4 there = here + (corner_x - f.x) * slope.x + (corner_y - f.y) * slope.y;
  // Where the plane is nearly seen from its edge it says nothing about depth.
  vec4 expected = mix(vec4(1.0), clamp(here / there, 0.5, 2.0), greaterThan(there * here, vec4(0.01 * here * here)));
  vec4 difference = mix(vec4(1e30), abs(depths / z - expected), greaterThan(depths, vec4(0.0)));

  vec4 bilinear = mix(vec4(1.0 - f.x), vec4(f.x), corner_x) * mix(vec4(1.0 - f.y), vec4(f.y), corner_y);
  vec4 weight = bilinear / (depth_epsilon + difference) * vec4(lessThanEqual(difference, vec4(depth_tolerance)));
  if (dot(weight, vec4(1.0)) <= 0.0) {
    float nearest = min(min(difference.x, difference.y), min(difference.z, difference.w));
    weight = vec4(lessThanEqual(difference, vec4(nearest)));
  }
  weight /= dot(weight, vec4(1.0));

  indirect = vec4(0.0);
  cover = vec2(0.0);
  for (int i = 0; i < 4; ++i) {
    ivec2 at = clamp(base + ivec2(corner_x[i], corner_y[i]), ivec2(0), coarse_size - 1);
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
