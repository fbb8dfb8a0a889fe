// The flux of a volume on each texel that lies in it, at the texel's own depth.
#include "techniques/caustics/flux.glsl"
#include "techniques/caustics/places.glsl"
#ifdef OCCLUDERS
#include "techniques/caustics/occlusion.glsl"
#endif
#include "techniques/caustics/triangles.glsl"

layout(location = 0) flat in uvec3 corner;
layout(location = 1) flat in vec3 flux;
layout(location = 2) flat in vec3 area;
layout(location = 3) flat in vec4 corner_ray[3];
layout(location = 6) flat in vec4 corner_way_spot[3];

layout(binding = 0) uniform sampler2D places;

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
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 place = texelFetch(places, texel, 0);
  if (!shows_receiver(place)) discard;
  float depth = place.x;
  vec4 ray_a = corner_ray[0], ray_b = corner_ray[1], ray_c = corner_ray[2];
  precise vec2 a = ray_a.xy + depth * ray_a.zw, b = ray_b.xy + depth * ray_b.zw, c = ray_c.xy + depth * ray_c.zw;
  vec2 point = gl_FragCoord.xy / vec2(textureSize(places, 0));
  vec3 part = vec3(to_the_left(point, corner.y, b, corner.z, c), to_the_left(point, corner.z, c, corner.x, a),
                   to_the_left(point, corner.x, a, corner.y, b));
  bvec3 left = greaterThan(part, vec3(0.0));
  if (left.x != left.y || left.y != left.z) discard;
  part /= part.x + part.y + part.z;
  vec4 way_spot = part.x * corner_way_spot[0] + part.y * corner_way_spot[1] + part.z * corner_way_spot[2];
  float way = way_spot.x + depth * way_spot.y;
  if (way <= 0.0) discard;  // above the water
  vec2 ray_step = part.x * ray_a.zw + part.y * ray_b.zw + part.z * ray_c.zw;
#ifdef OCCLUDERS
  if (is_occluded(places, texel, place, ray_step)) discard;
#endif
  caustics = flux_of(flux, area_at(area, depth), tilt_factor(ray_step, place), way, way_spot.zw);
}
