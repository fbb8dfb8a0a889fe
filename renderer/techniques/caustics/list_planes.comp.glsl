// Lists the used planes in order and has the volumes drawn once for each: the first invocation does it all.
#include "shaders/compute.glsl"
#include "techniques/caustics/draw_volumes.glsl"

uniform int plane_count;

layout(std430, binding = 0) readonly buffer Used { uint used[]; };
layout(std430, binding = 1) writeonly buffer Planes { uint planes[]; };

void main() {
  if (gl_GlobalInvocationID.x != 0u) return;
  uint count = 0u;
  for (int plane = 0; plane < plane_count; ++plane)
    if (used[plane] != 0u) planes[count++] = uint(plane);
  instances = count;
}
