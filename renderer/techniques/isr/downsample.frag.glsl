// Reduces blocks of pixels to patches: radiance is averaged over the pixels that show an object, position and normals
// are those of one such pixel nearest the block's middle, since a mean would lie on no surface.
#include "shaders/gbuffer.glsl"
#include "techniques/isr/coarse.glsl"

layout(binding = 9) uniform sampler2D light;  // SOURCE_LIT: the lit picture; SOURCE_DIFFUSE: irradiance

uniform int block;               // pixels along a block's edge
uniform float min_view_cosine;

layout(location = 0) out vec4 patch_out;
layout(location = 1) out vec4 radiance_out;
layout(location = 2) out vec2 normal_out;
layout(location = 3) out float depth_out;

const float kLargestHalf = 65504.0;

vec3 radiance(ivec2 pixel) {
#if defined(SOURCE_ALBEDO)
  return texelFetch(gbuffer_albedo, pixel, 0).rgb;
#elif defined(SOURCE_DIFFUSE)
  return texelFetch(gbuffer_emission, pixel, 0).rgb +
         texelFetch(gbuffer_albedo, pixel, 0).rgb * texelFetch(light, pixel, 0).rgb;
#else
  return texelFetch(light, pixel, 0).rgb;
#endif
}

void main() {
  ivec2 origin = ivec2(gl_FragCoord.xy) * block;
  ivec2 end = min(origin + block, ivec2(frame_size.xy));
  ivec2 middle = origin + middle_of(block);
  ivec2 chosen = ivec2(-1);
  int nearest = 1 << 20;
  vec3 sum = vec3(0.0);
  float count = 0.0;
  for (int y = origin.y; y < end.y; ++y) {
    for (int x = origin.x; x < end.x; ++x) {
      ivec2 pixel = ivec2(x, y);
      if (gbuffer_z(pixel) <= 0.0) continue;
      ivec2 off = pixel - middle;
      int distance2 = off.x * off.x + off.y * off.y;
      if (distance2 < nearest) {
        nearest = distance2;
        chosen = pixel;
      }
      sum += radiance(pixel);
      count += 1.0;
    }
  }
  patch_out = vec4(0.0, 0.0, 0.0, kNoPatch);
  radiance_out = vec4(0.0);
  normal_out = vec2(0.5);
  depth_out = 0.0;
  if (count == 0.0) return;

  vec2 uv = (vec2(chosen) + 0.5) * frame_size.zw;
  depth_out = gbuffer_z(chosen) * camera_position.w;
  vec3 position = unit_ray(uv) * depth_out;
  vec3 shading_normal = gbuffer_normal(chosen);
  normal_out = encode_octahedral(shading_normal);
#ifdef WEIGHTING_PAPER
  vec3 normal = shading_normal;
  float factor = texelFetch(gbuffer_albedo, chosen, 0).a;  // the radiation mask
#else
  // By how much the surface seen through the block is larger than the block at its depth.
  vec3 normal = gbuffer_geometric_normal(chosen);
  float view_cosine = max(-dot(normal, position) / eye_z(position), min_view_cosine);
  float factor = count / (float(block * block) * view_cosine);
#endif
  patch_out = vec4(position, pack_normal(normal));
  radiance_out = vec4(min(sum / count, kLargestHalf), factor);
}
