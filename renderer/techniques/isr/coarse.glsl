// The picture of low resolution that indirect light is gathered from and for (renderer/techniques/isr.h).
#include "shaders/frame.glsl"
#include "shaders/octahedral.glsl"

// Position relative to the camera; alpha: the patch's normal, packed, or kNoPatch where a block shows no object.
layout(binding = 6) uniform sampler2D coarse_patches;
// Radiance that leaves the patch; alpha: the patch's own factor (see downsample.frag.glsl).
layout(binding = 7) uniform sampler2D coarse_radiance;
const float kNoPatch = -1.0;

// The pixel of a block, counted from its first one, that stands for it where it shows an object.
ivec2 middle_of(int block) { return ivec2((block - 1) / 2); }

// Where in the block, in pixels from its first one's centre, the patch lies that stands for it.
vec2 patch_place(int block) {
#ifdef DOWNSAMPLING_MEAN
  return vec2(0.5 * float(block - 1));
#else
  return vec2(middle_of(block));
#endif
}

// Two times 12 bits are a whole number that a float holds exactly; so are the axes.
float pack_normal(vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 p = n.xy;
  if (n.z < 0.0) p = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
  vec2 q = round(p * 2047.0) + 2048.0;
  return q.x * 4096.0 + q.y;
}

vec3 unpack_normal(float packed_normal) {
  float x = floor(packed_normal * (1.0 / 4096.0));
  vec2 p = (vec2(x, packed_normal - x * 4096.0) - 2048.0) * (1.0 / 2047.0);
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  float fold = max(-n.z, 0.0);
  n.x += n.x >= 0.0 ? -fold : fold;
  n.y += n.y >= 0.0 ? -fold : fold;
  return normalize(n);
}

// Eye-space z of a position relative to the camera.
float eye_z(vec3 position) { return dot(position, camera_forward.xyz); }

// The ray of unit length along the camera's axis through a point of the picture, 0..1, y up.
vec3 unit_ray(vec2 uv) { return (far_corner.xyz + uv.x * far_u.xyz + uv.y * far_v.xyz) / camera_position.w; }
