// The flux that a triangle of the water sends onto each unit of the map's area (the water caustics thesis, 4.4 and 4.5, eq.
// 4-16 to 4-18).
uniform vec3 absorption;
uniform float least_area;
#ifdef SHADED
layout(binding = 1) uniform sampler2D open_water;  // of draw_water_shade
#endif

// `area`: of the image across the axis. `tilt`: tilt_factor of places.glsl. a: 1 where the area was raised to the least.
// `spot`: where the light came through the water's level.
vec4 flux_of(vec3 flux, float area, float tilt, float way, vec2 spot) {
  vec4 landed = vec4(flux * exp(-absorption * way) * tilt / max(area, least_area), area < least_area ? 1.0 : 0.0);
#ifdef SHADED
  landed.rgb *= textureLod(open_water, spot, 0.0).r;
#endif
  return landed;
}
