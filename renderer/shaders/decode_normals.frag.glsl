#include "shaders/gbuffer.glsl"

layout(location = 0) out vec4 normal;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  normal = gbuffer_z(pixel) > 0.0 ? vec4(gbuffer_normal(pixel), 1.0) : vec4(0.0);
}
