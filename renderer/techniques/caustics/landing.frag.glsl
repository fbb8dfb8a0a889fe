// The flux of triangles that were drawn where their corners land, for each unit of the map's area.
#include "techniques/caustics/flux.glsl"
#include "techniques/caustics/triangles.glsl"
#include "techniques/caustics/places.glsl"
#ifdef OCCLUDERS
#include "techniques/caustics/occlusion.glsl"
#endif

layout(binding = 0) uniform sampler2D places;

layout(location = 0) in float way;
layout(location = 1) in float depth;
layout(location = 2) in vec2 spot;
layout(location = 3) flat in vec3 flux;
layout(location = 4) flat in vec3 area;
layout(location = 5) in vec2 ray_step;

uniform float tolerance;

layout(location = 0) out vec4 caustics;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 place = texelFetch(places, texel, 0);
  if (!shows_receiver(place) || abs(place.x - depth) > tolerance) discard;
#ifdef OCCLUDERS
  if (is_occluded(places, texel, place, ray_step)) discard;
#endif
  caustics = flux_of(flux, area_at(area, place.x), tilt_factor(ray_step, place), way, spot);
}
