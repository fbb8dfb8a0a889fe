#ifdef CUTOUT
#include "shaders/cutout.glsl"
layout(location = 0) in vec2 surface_uv;

void main() {
  if (is_cut_out(surface_uv)) discard;
}
#else
void main() {}
#endif
