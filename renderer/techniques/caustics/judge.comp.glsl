// How each triangle of the water is drawn: where its corners land, or cut by planes since it straddles surfaces.
#include "shaders/compute.glsl"
#include "techniques/caustics/blocks.glsl"
#include "techniques/caustics/march.glsl"
#include "techniques/caustics/states.glsl"

layout(std430, binding = 0) readonly buffer Rays { vec4 rays[]; };
layout(std430, binding = 1) readonly buffer Hits { vec4 hits[]; };
layout(std430, binding = 2) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 3) writeonly buffer States { uint states[]; };
layout(std430, binding = 4) readonly buffer Blocks { vec2 blocks[]; };  // smallest and largest depth of the receiver
uniform int triangle_count;

// Whether the receiver lies at the mean of landings.
bool lies_on_receiver(vec3 at) {
  return abs(behind(vec4(at.xy, 0.0, 0.0), at.z)) <= tolerance && shows_receiver(at.xy);
}

vec2 least_at(float depth, vec4 a, vec4 b, vec4 c) {
  return min(min(a.xy + depth * a.zw, b.xy + depth * b.zw), c.xy + depth * c.zw);
}
vec2 most_at(float depth, vec4 a, vec4 b, vec4 c) {
  return max(max(a.xy + depth * a.zw, b.xy + depth * b.zw), c.xy + depth * c.zw);
}

// Whether some block of the map shows the receiver where the volume between three rays may reach it. By intervals of
// depth, in each of which the bounds of both ends hold the volume.
bool may_reach(vec4 a, vec4 b, vec4 c) {
  const int kIntervals = 8;
  ivec2 count = blocks_of(textureSize(places, 0));
  vec2 scale = vec2(textureSize(places, 0)) / float(kBlock);
  for (int i = 0; i < kIntervals; ++i) {
    float near = float(i) / float(kIntervals);
    float far = float(i + 1) / float(kIntervals);
    vec2 low = min(least_at(near, a, b, c), least_at(far, a, b, c));
    vec2 high = max(most_at(near, a, b, c), most_at(far, a, b, c));
    ivec2 first = ivec2(clamp(floor(low * scale), vec2(0.0), vec2(count)));
    ivec2 last = ivec2(clamp(floor(high * scale), vec2(-1.0), vec2(count - 1)));
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x) {
        vec2 depths = blocks[y * count.x + x];
        if (depths.x <= far && depths.y >= near) return true;
      }
  }
  return false;
}

void main() {
  int number = int(gl_GlobalInvocationID.x);
  if (number >= triangle_count) return;
  uint a = corners[3 * number], b = corners[3 * number + 1], c = corners[3 * number + 2];
  vec4 p = hits[a], q = hits[b], r = hits[c];
  int landed = int(p.w > 0.0) + int(q.w > 0.0) + int(r.w > 0.0);
  uint state = kStraddles;
  if (landed == 3) {
    vec3 pq = 0.5 * (p.xyz + q.xyz), qr = 0.5 * (q.xyz + r.xyz), rp = 0.5 * (r.xyz + p.xyz);
    if (lies_on_receiver(pq) && lies_on_receiver(qr) && lies_on_receiver(rp) &&
        lies_on_receiver((p.xyz + q.xyz + r.xyz) / 3.0))
      state = kLands;
  } else if (landed == 0 && !may_reach(rays[a], rays[b], rays[c])) {
    state = kMisses;
  }
  states[number] = state;
}
