// What keeps light from the water, projected onto its level: all that is above.
#ifdef CUTOUT
#include "shaders/cutout.glsl"
#endif

layout(location = 0) in vec3 relative_position;  // to a point on the level
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 surface_uv;
layout(location = 3) in vec3 surface_color;

layout(location = 0) out vec4 open;

void main() {
#ifdef CUTOUT
  if (is_cut_out(surface_uv)) discard;
#endif
  if (relative_position.y <= 0.0) discard;
  open = vec4(0.0);
}
