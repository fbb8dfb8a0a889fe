// What leaves both sides of each surface of the surround: emission, and what the albedo sends back of all that arrives.
#include "shaders/gbuffer.glsl"

layout(binding = 9) uniform sampler2D front_irradiance;
layout(binding = 10) uniform sampler2D back_irradiance;
#ifdef WITH_INDIRECT
layout(binding = 11) uniform sampler2D front_indirect;
layout(binding = 12) uniform sampler2D back_indirect;
#endif

layout(location = 0) out vec4 front;
layout(location = 1) out vec4 back;

const float kLargestHalf = 65504.0;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  front = vec4(0.0);
  back = vec4(0.0);
  if (gbuffer_z(pixel) <= 0.0) return;
  vec3 emission = texelFetch(gbuffer_emission, pixel, 0).rgb;
  vec4 albedo = texelFetch(gbuffer_albedo, pixel, 0);
  vec3 to_front = texelFetch(front_irradiance, pixel, 0).rgb;
  vec3 to_back = texelFetch(back_irradiance, pixel, 0).rgb;
#ifdef WITH_INDIRECT
  to_front += albedo.a * texelFetch(front_indirect, pixel, 0).rgb;
  to_back += albedo.a * texelFetch(back_indirect, pixel, 0).rgb;
#endif
  front.rgb = min(emission + albedo.rgb * to_front, kLargestHalf);
  back.rgb = min(emission + albedo.rgb * to_back, kLargestHalf);
}
