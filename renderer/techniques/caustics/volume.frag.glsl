// The flux that lands in the plane for each unit of its area (the water caustics thesis, 4.4 and 4.5, eq. 4-16 to 4-18).
#ifdef PLANE_DISCARD
#include "techniques/caustics/planes.glsl"
layout(binding = 0) uniform sampler2D places;
uniform float slices;
#elif !defined(ONE_PLANE)
layout(early_fragment_tests) in;  // against the planes of draw_plane_depths
#endif

layout(location = 0) in float way;
layout(location = 1) flat in float depth;
layout(location = 2) flat in int plane;

struct Triangle {
  vec4 flux;
  vec4 area;
};
layout(std430, binding = 0) readonly buffer Triangles { Triangle triangles[]; };
#ifdef LISTED_TRIANGLES
layout(std430, binding = 2) readonly buffer Listed { uint listed[]; };
#endif
uniform vec3 absorption;
uniform float least_area;

layout(location = 0) out vec4 caustics;  // a: 1 where the area was raised to the least

void main() {
#ifdef PLANE_DISCARD
  if (plane_of(texelFetch(places, ivec2(gl_FragCoord.xy), 0).xy, slices) != plane) discard;
#endif
  if (way <= 0.0) discard;  // above the water
#ifdef LISTED_TRIANGLES
  Triangle triangle = triangles[listed[gl_PrimitiveID]];
#else
  Triangle triangle = triangles[gl_PrimitiveID];
#endif
  float area = abs(triangle.area.x + depth * (triangle.area.y + depth * triangle.area.z));
  caustics = vec4(triangle.flux.rgb * exp(-absorption * way) / max(area, least_area), area < least_area ? 1.0 : 0.0);
}
