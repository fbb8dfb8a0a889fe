// How each triangle of the water lights the receiver: an invocation for each.
#include "shaders/compute.glsl"
#include "techniques/caustics/lights.glsl"
#include "techniques/caustics/march.glsl"
#ifdef SPLITS
#include "techniques/caustics/reach.glsl"
#endif

layout(std430, binding = 1) readonly buffer Hits { vec4 hits[]; };
layout(std430, binding = 2) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 3) writeonly buffer Lights { vec2 lights[]; };
uniform int triangle_count;

// Whether the receiver lies at the mean of landings.
bool lies_on_receiver(vec3 at) {
  return abs(behind(vec4(at.xy, 0.0, 0.0), at.z)) <= tolerance && receiver_at(at.xy);
}

bool lands(vec4 p, vec4 q, vec4 r) {
  vec3 pq = 0.5 * (p.xyz + q.xyz), qr = 0.5 * (q.xyz + r.xyz), rp = 0.5 * (r.xyz + p.xyz);
  return p.w > 0.0 && q.w > 0.0 && r.w > 0.0 && lies_on_receiver(pq) && lies_on_receiver(qr) && lies_on_receiver(rp) &&
         lies_on_receiver((p.xyz + q.xyz + r.xyz) / 3.0);
}

#ifdef SPLITS
layout(std430, binding = 0) readonly buffer Rays { vec4 rays[]; };

// The depths between which the volume may meet the receiver, in steps of a few planes.
vec2 met_by(vec4 a, vec4 b, vec4 c) {
  const int kSteps = 25;
  ivec2 size = textureSize(places, 0);
  int step = max((slices + kSteps) / kSteps, 1);
  int first = -1;
  int last = -1;
  for (int plane = 0; plane <= slices; plane += step) {
    if (!may_light(plane, plane + step - 1, a, b, c, size)) continue;
    if (first < 0) first = plane;
    last = plane + step - 1;
  }
  return first < 0 ? kMisses : vec2(float(first) - 0.5, float(last) + 0.5) / float(slices);
}
#endif

void main() {
  int number = int(gl_GlobalInvocationID.x);
  if (number >= triangle_count) return;
  uint a = corners[3 * number], b = corners[3 * number + 1], c = corners[3 * number + 2];
  vec2 light = lands(hits[a], hits[b], hits[c]) ? kLands : kMisses;
#ifdef SPLITS
  if (light == kMisses) light = met_by(rays[a], rays[b], rays[c]);
#endif
  lights[number] = light;
}
