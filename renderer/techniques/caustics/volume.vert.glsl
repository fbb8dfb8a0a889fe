// Illumination volumes, cut by a plane of the receiver's box.
#include "techniques/caustics/planes.glsl"

#ifdef LISTED_CUTS
#include "techniques/caustics/cuts.glsl"
layout(std430, binding = 2) readonly buffer Cuts { uint cuts[]; };
layout(std430, binding = 3) readonly buffer Rays { vec4 rays[]; };
layout(std430, binding = 4) readonly buffer Ways { vec2 ways[]; };
layout(std430, binding = 5) readonly buffer Corners { uint corners[]; };
layout(std430, binding = 6) readonly buffer Spots { vec2 spots[]; };
uniform int first;  // triangle
#else
layout(location = 0) in vec4 ray;      // place in the map at z = 0, and what each unit of z adds
layout(location = 1) in vec2 ray_way;  // the same of the way through the water
layout(location = 2) in vec2 ray_spot;
#endif

uniform float slices;
#ifdef ONE_PLANE
uniform int one_plane;
#endif
#ifdef LISTED_PLANES
layout(std430, binding = 1) readonly buffer Planes { uint planes[]; };
#endif

layout(location = 0) out float way;
layout(location = 1) flat out float depth;
layout(location = 2) flat out int plane;
layout(location = 3) out vec2 spot;
layout(location = 4) out vec2 ray_step;

invariant gl_Position;  // alike in all ways of drawing, to the bit
invariant way;

void main() {
#ifdef LISTED_CUTS
  uint cut = cuts[gl_VertexID / 3];
  plane = plane_of_cut(cut);
  uint number = corners[3 * (first + int(triangle_of_cut(cut))) + gl_VertexID % 3];
  vec4 ray = rays[number];
  vec2 ray_way = ways[number];
  vec2 ray_spot = spots[number];
#elif defined(ONE_PLANE)
  plane = one_plane;
#elif defined(LISTED_PLANES)
  plane = int(planes[gl_InstanceID]);
#else
  plane = gl_InstanceID;
#endif
  depth = float(plane) / slices;
  way = ray_way.x + depth * ray_way.y;
  spot = ray_spot;
  ray_step = ray.zw;
  gl_Position = vec4(2.0 * (ray.xy + depth * ray.zw) - 1.0, plane_depth(plane), 1.0);
}
