// The flux of a volume on each texel that lies in it, at the texel's own depth.
#include "techniques/caustics/flux.glsl"

layout(location = 0) flat in int triangle_number;

layout(binding = 0) uniform sampler2D places;
layout(std430, binding = 1) readonly buffer Rays { vec4 rays[]; };
layout(std430, binding = 2) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 4) readonly buffer Ways { vec2 ways[]; };
layout(std430, binding = 5) readonly buffer Spots { vec2 spots[]; };

layout(location = 0) out vec4 caustics;

// Twice the area from an edge to a point, positive on the left of a -> b. By the edge's lower corner first, so that the
// triangles on both sides of it agree to the bit, and a point is always in just one of them.
float to_the_left(vec2 point, uint from, vec2 a, uint to, vec2 b) {
  bool turned = from > to;
  vec2 start = turned ? b : a;
  vec2 edge = (turned ? a : b) - start;
  vec2 along = point - start;
  precise float twice = edge.x * along.y - edge.y * along.x;
  // On the edge: left of it from its lower corner. Far below any area that counts, and above what is flushed to 0.
  if (twice == 0.0) twice = 1e-30;
  return turned ? -twice : twice;
}

void main() {
  vec2 shown = texelFetch(places, ivec2(gl_FragCoord.xy), 0).xy;
  if (shown.y != 1.0) discard;
  float depth = shown.x;
  uvec3 corner = uvec3(corners[3 * triangle_number], corners[3 * triangle_number + 1], corners[3 * triangle_number + 2]);
  vec4 ray_a = rays[corner.x], ray_b = rays[corner.y], ray_c = rays[corner.z];
  precise vec2 a = ray_a.xy + depth * ray_a.zw, b = ray_b.xy + depth * ray_b.zw, c = ray_c.xy + depth * ray_c.zw;
  vec2 point = gl_FragCoord.xy / vec2(textureSize(places, 0));
  vec3 part = vec3(to_the_left(point, corner.y, b, corner.z, c), to_the_left(point, corner.z, c, corner.x, a),
                   to_the_left(point, corner.x, a, corner.y, b));
  bvec3 left = greaterThan(part, vec3(0.0));
  if (left.x != left.y || left.y != left.z) discard;
  part /= part.x + part.y + part.z;
  vec2 way_line = part.x * ways[corner.x] + part.y * ways[corner.y] + part.z * ways[corner.z];
  vec2 spot = part.x * spots[corner.x] + part.y * spots[corner.y] + part.z * spots[corner.z];
  float way = way_line.x + depth * way_line.y;
  if (way <= 0.0) discard;  // above the water
  Triangle triangle = triangles[triangle_number];
  caustics = flux_of(triangle, area_at(triangle, depth), way, spot);
}
