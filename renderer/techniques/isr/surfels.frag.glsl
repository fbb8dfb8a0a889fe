// What slices.frag.glsl needs to know of each texel of the surround: the plane of its surface.
#include "shaders/gbuffer.glsl"
#include "techniques/isr/surfel.glsl"

layout(location = 0) out vec3 surfel;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  surfel = vec3(0.0);
  float z = gbuffer_z(pixel) * camera_position.w;
  if (z <= 0.0) return;
  vec3 position = tile_ray(pixel) * z;
  vec3 normal = gbuffer_geometric_normal(pixel);
  mat3 eye = transpose(mat3(eye_right.xyz, eye_up.xyz, eye_forward.xyz));
  float packed_normal = pack_normal(eye * normal);
  // The plane of the normal as it will be read, so that it passes through the surface.
  float offset = dot(unpack_normal(packed_normal), eye * position);
  surfel = vec3(packed_normal, min(offset, 0.0), length(position));
}
