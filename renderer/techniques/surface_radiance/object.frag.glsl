// Which object a pixel shows, which side of it, and where in its texture: what nearer surfaces hide is never shaded.
#include "shaders/octahedral.glsl"
#ifdef CUTOUT
#include "shaders/cutout.glsl"
#endif

layout(location = 0) in vec3 world_normal;
layout(location = 1) in vec2 surface_uv;
layout(location = 2) in vec2 surface_texel;

uniform int object;

layout(location = 0) out vec4 place;   // texel coordinates; object's number + 1; 1 on the back
layout(location = 1) out vec2 normal;  // octahedral, towards the side that is seen

void main() {
#ifdef CUTOUT
  if (is_cut_out(surface_uv)) discard;
#endif
  place = vec4(surface_texel, float(object + 1), gl_FrontFacing ? 0.0 : 1.0);
  float size = length(world_normal);
  vec3 n = size > 0.0 ? world_normal / size : vec3(0.0, 1.0, 0.0);
  normal = encode_octahedral(gl_FrontFacing ? n : -n);
}
