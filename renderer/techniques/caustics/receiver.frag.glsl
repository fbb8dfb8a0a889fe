// The position and the diffuse map of a receiver: of all that stands in the water, what the light meets first. With SLICE the
// image of one slice of its box, with EXITS where what comes first ends.
#include "techniques/caustics/planes.glsl"
#ifdef CUTOUT
#include "shaders/cutout.glsl"
#endif

layout(location = 0) noperspective in vec2 depth_height;
layout(location = 1) noperspective in vec2 surface_uv;
layout(location = 2) noperspective in vec3 surface_color;

#if defined(SLICE)
layout(location = 0) out vec4 image;  // white where the receiver is, black where others are
uniform int slice;
uniform float slices;
#elif defined(EXITS)
layout(location = 0) out float exit_depth;
layout(binding = 7) uniform sampler2D places;
#else
layout(location = 0) out vec4 place;
#ifdef WITH_DIFFUSE
#include "shaders/material.glsl"
layout(location = 1) out vec4 diffuse;
#endif
#endif

uniform float water_top;
uniform float map_size;
uniform int entity;
uniform int receiver;

// What is kept of depth to find what is nearest.
float order_of(float depth) {
#ifdef EXITS
  return 0.5 + 0.5 * depth / (1.0 + abs(depth));  // as deep as the scene reaches
#else
  // Exactly the depth within the box, so that its slices agree with the whole of it; what stands over the box is squeezed
  // before that.
  const float kOver = 1e-10;
  return min(depth > kOver ? depth : kOver / (1.0 - depth), 1.0);
#endif
}

void main() {
  float depth = depth_height.x;
  // The slope is that of the triangle's own plane, so that no edge of the receiver is in it. Depth is linear over a triangle, and fragments beside
  // it lie on its plane too, so that differences are as exact as OpenGL places its corners. A plane that is steeper than
  // the box is high over one texel leaves the box within it.
  vec2 gradient = clamp(map_size * vec2(dFdx(depth), dFdy(depth)), -map_size, map_size);
#ifdef WITH_DIFFUSE
  diffuse = vec4(surface_diffuse(surface_uv, surface_color), 1.0);
#endif
#ifdef CUTOUT
  if (is_cut_out(surface_uv)) discard;
#endif
  if (depth_height.y > water_top) discard;
  gl_FragDepth = order_of(depth);
  bool is_back = gl_FrontFacing;  // the map's sides and the way of the light make a left-handed system
#if defined(SLICE)
  // What stands over the box comes first.
  if (max(nearest_plane(depth, slices), 0) != slice) discard;
  image = vec4(vec3(entity == receiver ? 1.0 : 0.0), 1.0);
#elif defined(EXITS)
  vec4 first = texelFetch(places, ivec2(gl_FragCoord.xy), 0);
  // What else stands in or against a solid does not end it.
  if (entity != entity_of(first) || is_back == shows_back_face(first)) discard;
  // By more than programs may differ by in what they interpolate.
  if (depth <= first.x + 1e-6 * max(abs(first.x), 1.0)) discard;
  exit_depth = depth;
#else
  place = vec4(depth, owner_of(entity, receiver, is_back), gradient);
#endif
}
