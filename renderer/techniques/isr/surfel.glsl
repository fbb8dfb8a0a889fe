// Texels of the surround as pieces of surfaces: x: unit normal towards the camera along the eye axes, packed; y: the
// plane's offset along it (not positive); z: distance from the camera, 0 where there is no surface.
#include "techniques/isr/coarse.glsl"

// Relative to the camera, along the eye axes; `ray` is the texel's, along those of the world.
vec3 surfel_position(vec3 ray, vec3 surfel) {
  vec3 eye_ray = vec3(dot(ray, eye_right.xyz), dot(ray, eye_up.xyz), dot(ray, eye_forward.xyz));
  return normalize(eye_ray) * surfel.z;
}
