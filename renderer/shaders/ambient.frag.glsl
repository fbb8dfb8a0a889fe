// A constant ambient irradiance, added to the lit picture.
#include "shaders/gbuffer.glsl"

layout(location = 0) out vec4 lit;
uniform vec3 ambient;

void main() {
  vec4 albedo = texelFetch(gbuffer_albedo, ivec2(gl_FragCoord.xy), 0);
  lit = vec4(albedo.rgb * albedo.a * ambient, 0.0);
}
