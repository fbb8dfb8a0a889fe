// The planes of a position map's texels as a depth buffer.
#include "techniques/caustics/planes.glsl"

layout(binding = 0) uniform sampler2D places;
uniform float slices;

void main() {
  gl_FragDepth = plane_depth(plane_of(texelFetch(places, ivec2(gl_FragCoord.xy), 0), slices));
}
