// What leaves the surfaces of the surround towards the camera: PANORAMA: all around, longitude across and latitude along the
// picture, the view's direction in the middle; else along the rays of the frame's pixels. 0 where there is no surface.
#include "shaders/frame.glsl"
#include "shaders/tiles.glsl"

layout(binding = 10) uniform sampler2D radiance;
uniform int layer;  // 0 is the nearest

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 color;

const float kPi = 3.14159265;

vec3 direction() {
  vec2 place = 2.0 * uv - 1.0;
#ifdef PANORAMA
  vec2 angles = place * vec2(kPi, 0.5 * kPi);
  return vec3(sin(angles.x) * cos(angles.y), sin(angles.y), cos(angles.x) * cos(angles.y));
#else
  return vec3(place * half_angles.xy, 1.0);
#endif
}

void main() {
  ivec2 texel = tile_texel(direction());
  texel.y += layer * int(eye_up.w);
  color = texel.x < 0 ? vec4(0.0) : vec4(texelFetch(radiance, texel, 0).rgb, 1.0);
}
