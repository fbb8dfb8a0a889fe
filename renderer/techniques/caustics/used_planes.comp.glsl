// Which planes any texel of a position map belongs to (smart slicing, the water caustics thesis, 4.7.2): an invocation for
// each row.
#include "shaders/compute.glsl"
#include "techniques/caustics/planes.glsl"

layout(binding = 0) uniform sampler2D places;
uniform float slices;

layout(std430, binding = 0) writeonly buffer Used { uint used[]; };

void main() {
  ivec2 size = textureSize(places, 0);
  int y = int(gl_GlobalInvocationID.x);
  if (y >= size.y) return;
  int last = -1;
  for (int x = 0; x < size.x; ++x) {
    int plane = plane_of(texelFetch(places, ivec2(x, y), 0), slices);
    if (plane != last && plane >= 0) used[plane] = 1u;
    last = plane;
  }
}
