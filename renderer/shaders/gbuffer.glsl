// Reading a G-buffer (renderer/gbuffer.h) that was bound with GBuffer::bind. Texture units 0 to 5 are taken.
// Pixels with depth 0 show the background: skip them, their other values mean nothing.
#include "shaders/frame.glsl"
#include "shaders/octahedral.glsl"

layout(binding = 0) uniform sampler2D gbuffer_albedo;
layout(binding = 1) uniform sampler2D gbuffer_normals;
layout(binding = 2) uniform sampler2D gbuffer_depth;
layout(binding = 3) uniform sampler2D gbuffer_specular;
layout(binding = 4) uniform sampler2D gbuffer_geometric_normals;
layout(binding = 5) uniform sampler2D gbuffer_emission;

vec3 decode_gbuffer_normal(vec4 stored) {
#ifdef NORMALS_RGB8
  return normalize(stored.xyz * 2.0 - 1.0);
#else
  return decode_octahedral(stored.xy);
#endif
}

// Eye-space z / far.
float gbuffer_z(ivec2 pixel) { return texelFetch(gbuffer_depth, pixel, 0).r; }
vec3 gbuffer_normal(ivec2 pixel) { return decode_gbuffer_normal(texelFetch(gbuffer_normals, pixel, 0)); }
vec3 gbuffer_geometric_normal(ivec2 pixel) {
  return decode_octahedral(texelFetch(gbuffer_geometric_normals, pixel, 0).xy);
}

// The position at the centre of a pixel of the G-buffer, where z is its depth as kept.
#ifdef TILED
#include "shaders/tiles.glsl"
vec3 gbuffer_position(ivec2 pixel, float z) { return camera_position.xyz + tile_ray(pixel) * (z * camera_position.w); }
#else
vec3 gbuffer_position(ivec2 pixel, float z) { return world_position((vec2(pixel) + 0.5) * frame_size.zw, z); }
#endif
