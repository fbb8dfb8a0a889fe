// What shows without the light that comes through the water: emission, ambient light, and direct light on what is above.
#include "shaders/gbuffer.glsl"

layout(location = 0) out vec4 lit;
uniform float water_height;
uniform vec3 ambient;
#ifdef WITH_DRY
layout(binding = 6) uniform sampler2D direct;
#endif

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  lit = texelFetch(gbuffer_emission, pixel, 0);
  float z = gbuffer_z(pixel);
  if (z <= 0.0) return;
#ifdef WITH_DRY
  if (gbuffer_position(pixel, z).y > water_height) lit = texelFetch(direct, pixel, 0);
#endif
  lit.rgb += ambient * texelFetch(gbuffer_albedo, pixel, 0).rgb;
}
