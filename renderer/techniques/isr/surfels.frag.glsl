// What slices.frag.glsl needs to know of each texel of the surround: the plane of its surface.
#include "shaders/gbuffer.glsl"
#include "techniques/isr/surfel.glsl"

layout(location = 0) out vec4 surfel;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  surfel = vec4(0.0);
  float z = gbuffer_z(pixel) * camera_position.w;
  if (z <= 0.0) return;
  vec3 position = tile_ray(pixel) * z;
  mat3 eye = transpose(mat3(eye_right.xyz, eye_up.xyz, eye_forward.xyz));
  vec3 normal = eye * gbuffer_geometric_normal(pixel);
  surfel = length(position) * vec4(normal, min(dot(normal, eye * position), 0.0));
}
