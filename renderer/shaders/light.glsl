// One light and its shadow map (renderer/shadow_map.h).
struct ShadowView {
  vec4 right;    // xyz: the map's axis, so that a plane at distance 1 spans -1..1; w: centre of what is seen
  vec4 up;
  vec4 forward;  // w: 1 where the view was drawn, 0 where nothing visible lies in it
};

layout(std140, binding = 1) uniform Light {
  vec4 light_position;   // w: 1 where the light stands somewhere, 0 where it is directional
  vec4 light_direction;  // unit, the way the light travels; w: 1 for a spot
  vec4 light_color;      // colour * power; w: share of the mean visibility
  vec4 light_attenuation;  // kind (Attenuation::Kind), distance, power, radius
  vec4 light_cone;       // cosines of the inner and the outer half-angle
  vec4 shadow_origin;    // w: near plane of a perspective view, depth range of an orthographic one
  vec4 shadow_extent;    // texels along an edge, 1 / that, depth that counts as 1 in exponential maps, unused
  vec4 shadow_slices;    // orthographic: logarithm of the nearest depth, slices per doubling, last slice, unused
  ShadowView shadow_views[6];
};

// The view of a point that lies at d from shadow_origin and at depth z (as the G-buffer has it) from the camera: the
// cube's face, the slice of depths in which the point lies, or the only one.
int shadow_view_of(vec3 d, float z) {
#ifdef SHADOW_CUBE
  vec3 size = abs(d);
  if (size.x >= size.y && size.x >= size.z) return d.x > 0.0 ? 0 : 1;
  if (size.y >= size.z) return d.y > 0.0 ? 2 : 3;
  return d.z > 0.0 ? 4 : 5;
#elif defined(SHADOW_ORTHOGRAPHIC)
  return int(clamp((log2(z) - shadow_slices.x) * shadow_slices.y, 0.0, shadow_slices.z));
#else
  return 0;
#endif
}

// Coordinates across and depth along the view. Perspective: on the plane at distance 1.
vec3 to_shadow_view(int view, vec3 d) {
  ShadowView v = shadow_views[view];
  vec3 q = vec3(dot(v.right.xyz, d), dot(v.up.xyz, d), dot(v.forward.xyz, d));
#ifndef SHADOW_ORTHOGRAPHIC
  q.xy /= q.z;
#endif
  return vec3(q.xy - vec2(v.right.w, v.up.w), q.z);
}
