// Lists the triangles that straddle surfaces, in order, each run after those before it, and has them drawn.
#include "shaders/compute.glsl"
#include "techniques/caustics/draw_volumes.glsl"
#include "techniques/caustics/states.glsl"

layout(std430, binding = 0) readonly buffer States { uint states[]; };
layout(std430, binding = 1) readonly buffer Counts { uint counts[]; };
layout(std430, binding = 2) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 3) writeonly buffer Listed { uint listed[]; };
layout(std430, binding = 4) writeonly buffer Indices { uint indices[]; };
uniform int triangle_count;
uniform int run_length;

void main() {
  int run = int(gl_GlobalInvocationID.x);
  int first = run * run_length;
  if (first >= triangle_count) return;
  uint place = 0u;
  for (int i = 0; i < run; ++i) place += counts[i];
  for (int i = first; i < min(first + run_length, triangle_count); ++i) {
    if (states[i] != kStraddles) continue;
    listed[place] = uint(i);
    for (int corner = 0; corner < 3; ++corner) indices[3u * place + uint(corner)] = corners[3 * i + corner];
    ++place;
  }
  if (first + run_length >= triangle_count) index_count = 3u * place;
}
