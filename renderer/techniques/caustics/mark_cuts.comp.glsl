// Which planes each triangle of the water is to be cut by: those that the receiver lies on in blocks of its map that the
// triangle's image may touch there. A bit for each plane; an invocation for each word of them.
#include "shaders/compute.glsl"
#include "techniques/caustics/reach.glsl"

layout(binding = 0) uniform sampler2D places;
layout(std430, binding = 0) readonly buffer Rays { vec4 rays[]; };
layout(std430, binding = 1) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 2) writeonly buffer Marks { uint marks[]; };
uniform int first;
uniform int listed;  // triangles
uniform int words;   // for each triangle

void main() {
  int number = int(gl_GlobalInvocationID.x);
  if (number >= listed * words) return;
  int triangle = first + number / words;
  vec4 a = rays[corners[3 * triangle]], b = rays[corners[3 * triangle + 1]], c = rays[corners[3 * triangle + 2]];
  int first_plane = 32 * (number % words);
  int last_plane = min(first_plane + 31, slices);
  ivec2 size = textureSize(places, 0);
  uint marked = 0u;
  if (may_light(first_plane, last_plane, a, b, c, size))
    for (int plane = first_plane; plane <= last_plane; ++plane)
      if (may_light(plane, plane, a, b, c, size)) marked |= 1u << uint(plane - first_plane);
  marks[number] = marked;
}
