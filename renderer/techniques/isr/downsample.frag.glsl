// Reduces blocks of pixels to patches. Radiance is averaged over the pixels that show an object. Position and normals are
// those of one such pixel nearest the block's middle, since a mean would lie on no surface; with DOWNSAMPLING_MEAN depth,
// normals and mask are averaged too (image-space radiosity thesis, section 4.2).
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

struct Surface {
  float z;  // in units of the far plane
  vec3 normal;
  vec3 geometric_normal;
  float mask;  // of what it reflects
};

Surface surface_at(ivec2 pixel) {
  return Surface(gbuffer_z(pixel), gbuffer_normal(pixel), gbuffer_geometric_normal(pixel),
                 texelFetch(gbuffer_albedo, pixel, 0).a);
}

#ifdef DOWNSAMPLING_MEAN
void add(Surface s, inout Surface sum) {
  sum.z += s.z;
  sum.normal += s.normal;
  sum.geometric_normal += s.geometric_normal;
  sum.mask += s.mask;
}

// Returns the mean of normals, of unit length. Opposite normals have none; for them it returns that of one pixel.
vec3 mean_normal(vec3 sum, vec3 one) { return dot(sum, sum) > 1e-6 ? normalize(sum) : one; }

Surface mean_surface(Surface sum, float count, Surface one) {
  return Surface(sum.z / count, mean_normal(sum.normal, one.normal),
                 mean_normal(sum.geometric_normal, one.geometric_normal), sum.mask / count);
}
#endif

void main() {
  ivec2 origin = ivec2(gl_FragCoord.xy) * block;
  ivec2 end = min(origin + block, ivec2(frame_size.xy));
  ivec2 middle = origin + middle_of(block);
  ivec2 chosen = ivec2(-1);
  int nearest = 1 << 20;
  vec3 sum = vec3(0.0);
  float count = 0.0;
#ifdef DOWNSAMPLING_MEAN
  Surface surface_sum = Surface(0.0, vec3(0.0), vec3(0.0), 0.0);
#endif
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
#ifdef DOWNSAMPLING_MEAN
      add(surface_at(pixel), surface_sum);
#endif
    }
  }
  patch_out = vec4(0.0, 0.0, 0.0, kNoPatch);
  radiance_out = vec4(0.0);
  normal_out = vec2(0.5);
  depth_out = 0.0;
  if (count == 0.0) return;

  Surface surface = surface_at(chosen);
  vec2 place = vec2(chosen);
#ifdef DOWNSAMPLING_MEAN
  surface = mean_surface(surface_sum, count, surface);
  place = vec2(origin) + patch_place(block);
#endif
  depth_out = surface.z * camera_position.w;
  vec3 position = unit_ray((place + 0.5) * frame_size.zw) * depth_out;
  normal_out = encode_octahedral(surface.normal);
#ifdef WEIGHTING_PAPER
  vec3 normal = surface.normal;
  float factor = surface.mask;
#else
  // By how much the surface seen through the block is larger than the block at its depth.
  vec3 normal = surface.geometric_normal;
  float view_cosine = max(-dot(normal, position) / eye_z(position), min_view_cosine);
  float factor = count / (float(block * block) * view_cosine);
#endif
  patch_out = vec4(position, pack_normal(normal));
  radiance_out = vec4(min(sum / count, kLargestHalf), factor);
}
