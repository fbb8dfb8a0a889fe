// Texels of the surround as pieces of surfaces. xyz: the unit normal towards the camera, along the eye axes, times the
// distance from the camera; w: the plane's offset along the normal (not positive), times that distance. All 0 where there is
// no surface.
#include "techniques/isr/coarse.glsl"

bool is_surface(vec4 surfel) { return surfel.xyz != vec3(0.0); }

vec3 surfel_normal(vec4 surfel) { return normalize(surfel.xyz); }

// Relative to the camera, along the eye axes; `ray` is the texel's, along those of the world.
vec3 surfel_position(vec3 ray, vec4 surfel) {
  vec3 eye_ray = vec3(dot(ray, eye_right.xyz), dot(ray, eye_up.xyz), dot(ray, eye_forward.xyz));
  return normalize(eye_ray) * length(surfel.xyz);
}
