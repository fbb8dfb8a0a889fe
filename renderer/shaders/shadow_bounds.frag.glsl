// What of each shadow view is seen by the camera: the smallest and largest coordinates over a block of pixels.
#include "shaders/gbuffer.glsl"
#include "shaders/light.glsl"

layout(location = 0) out vec4 bounds[6];  // smallest x and y, largest x and y; empty where the smallest is larger
layout(location = 6) out vec2 depths;     // smallest and largest depth along an orthographic view, or distance to the light

uniform int block_size;

void main() {
  ivec2 first = ivec2(gl_FragCoord.xy) * block_size;
  ivec2 last = min(first + block_size, ivec2(frame_size.xy));
  vec2 smallest[6];
  vec2 largest[6];
  for (int i = 0; i < 6; ++i) {
    smallest[i] = vec2(1e30);
    largest[i] = vec2(-1e30);
  }
  depths = vec2(1e30, -1e30);
  for (int y = first.y; y < last.y; ++y)
    for (int x = first.x; x < last.x; ++x) {
      float z = gbuffer_z(ivec2(x, y));
      if (z <= 0.0) continue;
      vec3 d = gbuffer_position(ivec2(x, y), z) - shadow_origin.xyz;
      int view = shadow_view_of(d, z);
      vec3 q = to_shadow_view(view, d);
#ifdef SHADOW_ORTHOGRAPHIC
      float depth = q.z;
#else
      if (q.z <= 0.0) continue;
      float depth = length(d);
#endif
      depths = vec2(min(depths.x, depth), max(depths.y, depth));
      smallest[view] = min(smallest[view], q.xy);
      largest[view] = max(largest[view], q.xy);
    }
  for (int i = 0; i < 6; ++i) bounds[i] = vec4(smallest[i], largest[i]);
}
