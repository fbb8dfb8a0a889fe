// The position and the diffuse map of a receiver: of all that stands in the water, what the light meets first. Or the
// image of one slice of its box.
#ifdef CUTOUT
#include "shaders/cutout.glsl"
#endif

layout(location = 0) noperspective in vec2 depth_height;
layout(location = 1) noperspective in vec2 surface_uv;
layout(location = 2) noperspective in vec3 surface_color;

#ifdef SLICE
#include "techniques/caustics/planes.glsl"
layout(location = 0) out vec4 image;  // white where the receiver is, black where others are
uniform int slice;
uniform float slices;
vec2 place;
#else
layout(location = 0) out vec2 place;
#endif
#ifdef WITH_DIFFUSE
#include "shaders/material.glsl"
layout(location = 1) out vec4 diffuse;
#endif

uniform float water_top;
uniform int entity;
uniform int receiver;

void main() {
#ifdef WITH_DIFFUSE
  diffuse = vec4(surface_diffuse(surface_uv, surface_color), 1.0);
#endif
#ifdef CUTOUT
  if (is_cut_out(surface_uv)) discard;
#endif
  if (depth_height.y > water_top) discard;
  place = vec2(depth_height.x, entity == receiver ? 1.0 : 0.0);
  // Exactly what is kept, so that slices of the box agree with the whole of it on what is nearest.
  gl_FragDepth = clamp(place.x, 0.0, 1.0);
#ifdef SLICE
  // What stands over the box comes first.
  if (max(nearest_plane(place.x, slices), 0) != slice) discard;
  image = vec4(vec3(place.y), 1.0);
#endif
}
