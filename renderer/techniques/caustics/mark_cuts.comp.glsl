// Which planes each triangle of the water is to be cut by: those that the receiver lies on in blocks of its map that the
// triangle's image may touch there. An invocation for each triangle; a bit for each plane.
#include "shaders/compute.glsl"
#include "techniques/caustics/reach.glsl"

layout(binding = 0) uniform sampler2D places;
layout(std430, binding = 0) readonly buffer Rays { vec4 rays[]; };
layout(std430, binding = 1) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 2) writeonly buffer Marks { uint marks[]; };
layout(std430, binding = 3) writeonly buffer Counts { uint counts[]; };  // of each group
uniform int first;
uniform int triangle_count;  // to the end of those that are listed now
uniform int words;  // of bits, for each triangle

shared uint count_of[gl_WorkGroupSize.x];

uint marks_of(int word, vec4 a, vec4 b, vec4 c) {
  int first_plane = 32 * word;
  int last_plane = min(first_plane + 31, slices);
  ivec2 size = textureSize(places, 0);
  uint marked = 0u;
  if (!may_light(first_plane, last_plane, a, b, c, size)) return marked;
  for (int plane = first_plane; plane <= last_plane; ++plane)
    if (may_light(plane, plane, a, b, c, size)) marked |= 1u << uint(plane - first_plane);
  return marked;
}

void main() {
  int number = int(gl_GlobalInvocationID.x);
  int triangle = first + number;
  uint count = 0u;
  if (triangle < triangle_count) {
    vec4 a = rays[corners[3 * triangle]], b = rays[corners[3 * triangle + 1]], c = rays[corners[3 * triangle + 2]];
    for (int word = 0; word < words; ++word) {
      uint marked = marks_of(word, a, b, c);
      marks[number * words + word] = marked;
      count += uint(bitCount(marked));
    }
  }
  count_of[gl_LocalInvocationID.x] = count;
  barrier();
  if (gl_LocalInvocationID.x != 0u) return;
  uint sum = 0u;
  for (uint i = 0u; i < gl_WorkGroupSize.x; ++i) sum += count_of[i];
  counts[gl_WorkGroupID.x] = sum;
}
