// The flux that lands in the plane.
#include "techniques/caustics/flux.glsl"
#include "techniques/caustics/triangles.glsl"
#include "techniques/caustics/planes.glsl"
#ifdef OCCLUDERS
#include "techniques/caustics/occlusion.glsl"
#endif

layout(binding = 0) uniform sampler2D places;
uniform float slices;
#if !defined(PLANE_DISCARD) && !defined(ONE_PLANE)
layout(early_fragment_tests) in;  // against the planes of draw_plane_depths
#endif

layout(location = 0) in float way;
layout(location = 1) flat in float depth;
layout(location = 2) flat in int plane;
layout(location = 3) in vec2 spot;
layout(location = 4) in vec2 ray_step;

#ifdef LISTED_CUTS
#include "techniques/caustics/cuts.glsl"
layout(std430, binding = 2) readonly buffer Cuts { uint cuts[]; };
uniform int first;
#endif

layout(location = 0) out vec4 caustics;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 place = texelFetch(places, texel, 0);
#ifdef PLANE_DISCARD
  if (plane_of(place, slices) != plane) discard;
#endif
  if (way <= 0.0) discard;  // above the water
#ifdef OCCLUDERS
  // A texel takes light from its own plane alone.
  if (plane_of(place, slices) != plane || is_occluded(places, texel, place, ray_step)) discard;
#endif
#ifdef LISTED_CUTS
  Triangle triangle = triangles[first + int(triangle_of_cut(cuts[gl_PrimitiveID]))];
#else
  Triangle triangle = triangles[gl_PrimitiveID];
#endif
  caustics = flux_of(triangle.flux.rgb, area_at(triangle.area.xyz, depth), tilt_factor(ray_step, place), way, spot);
}
