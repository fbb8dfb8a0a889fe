// Bilateral upsampling (eq. 27 and 28) and the final light (eq. 29).
#include "shaders/gbuffer.glsl"
#include "techniques/isr/coarse.glsl"

layout(binding = 9) uniform sampler2D indirect_in;
layout(binding = 10) uniform sampler2D openness_in;
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
layout(location = 2) out float openness_out;
#endif

struct Coarse {
  vec4 indirect;
  float openness;
};

Coarse fetch_coarse(ivec2 at) {
  Coarse result;
  result.indirect = texelFetch(indirect_in, at, 0);
#ifdef OCCLUSION
  result.openness = texelFetch(openness_in, at, 0).r;
#else
  result.openness = 1.0;
#endif
  return result;
}

// Patches stand for the pixel in the middle of their block. Depths are compared along the pixel's tangent plane, so that a slanted
// surface fits itself.
Coarse upsample(ivec2 pixel, float z) {
  ivec2 from_middle = pixel - middle_of(block);
  ivec2 base = ivec2(floor(vec2(from_middle) / float(block)));
  vec2 f = vec2(from_middle - base * block) / float(block);
  vec2 uv = (vec2(pixel) + 0.5) * frame_size.zw;
  vec3 normal = gbuffer_geometric_normal(pixel);
  float here = dot(normal, unit_ray(uv));
  vec2 slope = vec2(dot(normal, far_u.xyz), dot(normal, far_v.xyz)) / camera_position.w;

  Coarse sum = Coarse(vec4(0.0), 0.0);
  float weights = 0.0;
  float nearest = 1e30;
  ivec2 nearest_at = pixel / block;
  for (int i = 0; i < 4; ++i) {
    ivec2 corner = ivec2(i & 1, i >> 1);
    ivec2 at = clamp(base + corner, ivec2(0), coarse_size - 1);
    vec4 other = texelFetch(coarse_patches, at, 0);
    if (other.w == kNoPatch) continue;
    vec2 off = vec2(at * block - from_middle) * frame_size.zw;
    float there = here + dot(off, slope);
    // Where the plane is nearly seen from its edge it says nothing about depth.
    float expected = there * here > 0.01 * here * here ? clamp(here / there, 0.5, 2.0) : 1.0;
    float difference = abs(eye_z(other.xyz) / z - expected);
    if (difference < nearest) {
      nearest = difference;
      nearest_at = at;
    }
    if (difference > depth_tolerance) continue;
    vec2 b = mix(1.0 - f, f, vec2(corner));
    float weight = b.x * b.y / (depth_epsilon + difference);
    Coarse c = fetch_coarse(at);
    sum.indirect += weight * c.indirect;
    sum.openness += weight * c.openness;
    weights += weight;
  }
  if (weights <= 0.0) return fetch_coarse(nearest_at);
  return Coarse(sum.indirect / weights, sum.openness / weights);
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  float z = gbuffer_z(pixel) * camera_position.w;
#ifdef KEEP_BUFFERS
  indirect_out = vec4(0.0);
  openness_out = 1.0;
#endif
#ifdef INDIRECT_ONLY
  image = vec4(0.0);
#else
  image = texelFetch(lit, pixel, 0);
#endif
  if (z <= 0.0) return;

  Coarse coarse = upsample(pixel, z);
  vec3 indirect = coarse.indirect.rgb;
#ifdef ENERGY_BOUND
  indirect /= max(coarse.indirect.a, 1.0);  // a full hemisphere of form factors adds up to 1
#endif
#ifdef WEIGHTING_AREA
  vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
  indirect *= albedo.rgb * albedo.a;
#endif
  indirect *= k_isr;
#if defined(OCCLUSION) && !defined(INDIRECT_ONLY)
  vec3 emission = texelFetch(gbuffer_emission, pixel, 0).rgb;
  image.rgb = emission + (image.rgb - emission) * clamp(coarse.openness + 1.0 - k_ssao, 0.0, 1.0);
#endif
  image = vec4(image.rgb + indirect, 1.0);
#ifdef KEEP_BUFFERS
  indirect_out = vec4(indirect, 1.0);
  openness_out = coarse.openness;
#endif
}
