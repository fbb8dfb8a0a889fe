// Depths of one view of a shadow map over the light's range. Where nothing stands in the way they are those of the end.
#include "shaders/light.glsl"

layout(binding = 8) uniform sampler2DArray shadow_map;
layout(location = 0) out float depth;
uniform int view;

void main() {
  float stored = texelFetch(shadow_map, ivec3(gl_FragCoord.xy, view), 0).r;
#ifdef SHADOW_ORTHOGRAPHIC
  depth = (1.0 - stored) * shadow_origin.w / shadow_extent.z;
#else
  depth = stored > 0.0 ? min(shadow_origin.w / stored / shadow_extent.z, 1.0) : 1.0;
#endif
}
