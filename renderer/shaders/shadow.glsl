// Visibility of the light from a point, by the map. Needs gbuffer.glsl and light.glsl.
layout(binding = 8) uniform sampler2DArray shadow_map;

struct Receiver {
  vec3 d;       // from shadow_origin
  vec3 normal;  // of its plane
  int view;
  vec2 st;      // -1..1 over the map
  float depth;  // along the view
};

Receiver receiver_at(vec3 position, vec3 geometric_normal) {
  Receiver r;
  r.d = position - shadow_origin.xyz;
  r.normal = geometric_normal;
  r.view = shadow_view_of(r.d);
  vec3 q = to_shadow_view(r.view, r.d);
  r.st = q.xy;
  r.depth = q.z;
  return r;
}

#ifdef SHADOW_ESM
// The map holds blurred occluder depths, 0..1 over the light's range.
float visibility(Receiver r, float n_dot_l) {
  vec2 texel = (r.st * 0.5 + 0.5) * shadow_extent.x - 0.5;
  ivec2 corner = ivec2(floor(texel));
  vec2 f = texel - vec2(corner);
  float depth = r.depth / shadow_extent.z;
  float result = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 offset = ivec2(i & 1, i >> 1);
    ivec2 at = clamp(corner + offset, ivec2(0), ivec2(shadow_extent.x) - 1);
    float occluder = texelFetch(shadow_map, ivec3(at, r.view), 0).r;
    float weight = (offset.x == 0 ? 1.0 - f.x : f.x) * (offset.y == 0 ? 1.0 - f.y : f.y);
    result += weight * exp(-esm_sharpness * max(depth - occluder, 0.0) * clamp(n_dot_l, 0.0, 1.0));
  }
  return result;
}
#else
// The stored depth of the receiver's plane where the ray through a map position meets it. It is an affine function of the
// position, so that a plane never shadows itself, at any angle and resolution.
float plane_depth(Receiver r, vec2 st) {
  ShadowView v = shadow_views[r.view];
  vec2 offset = st - r.st;
#ifdef SHADOW_ORTHOGRAPHIC
  vec3 right = v.right.xyz / dot(v.right.xyz, v.right.xyz);
  vec3 up = v.up.xyz / dot(v.up.xyz, v.up.xyz);
  float along = dot(r.normal, v.forward.xyz);
  float slope = -dot(r.normal, offset.x * right + offset.y * up);
  return 1.0 - (r.depth + slope / (abs(along) < 1e-6 ? 1e-6 : along)) / shadow_origin.w;
#else
  vec3 right = v.right.xyz / dot(v.right.xyz, v.right.xyz);
  vec3 up = v.up.xyz / dot(v.up.xyz, v.up.xyz);
  vec3 ray_change = offset.x * right + offset.y * up;
  float across = dot(r.normal, r.d) / r.depth;
  float change = dot(r.normal, ray_change) / (abs(across) < 1e-6 ? 1e-6 : across);
  return shadow_origin.w / r.depth * (1.0 + clamp(change, -0.25, 0.25));
#endif
}

float lit_at(Receiver r, ivec2 texel) {
  vec2 st = (vec2(texel) + 0.5) * shadow_extent.y * 2.0 - 1.0;
  float occluder = texelFetch(shadow_map, ivec3(texel, r.view), 0).r;
  float receiver = plane_depth(r, st);
#ifdef SHADOW_ORTHOGRAPHIC
  return occluder > receiver + shadow_bias ? 0.0 : 1.0;
#else
  return occluder > receiver * (1.0 + shadow_bias) ? 0.0 : 1.0;
#endif
}

#ifdef SHADOW_PCF
float visibility(Receiver r, float n_dot_l) {
  vec2 texel = (r.st * 0.5 + 0.5) * shadow_extent.x - 0.5;
  ivec2 corner = ivec2(floor(texel));
  vec2 f = texel - vec2(corner);
  float sum = 0.0;
  float weights = 0.0;
  for (int y = -pcf_radius; y <= pcf_radius + 1; ++y)
    for (int x = -pcf_radius; x <= pcf_radius + 1; ++x) {
      // A box of (2r+1) texels slides over the map: its ends count in part.
      vec2 weight = vec2(x == -pcf_radius ? 1.0 - f.x : (x == pcf_radius + 1 ? f.x : 1.0),
                         y == -pcf_radius ? 1.0 - f.y : (y == pcf_radius + 1 ? f.y : 1.0));
      ivec2 at = clamp(corner + ivec2(x, y), ivec2(0), ivec2(shadow_extent.x) - 1);
      sum += weight.x * weight.y * lit_at(r, at);
      weights += weight.x * weight.y;
    }
  return sum / weights;
}
#else
float visibility(Receiver r, float n_dot_l) {
  ivec2 texel = ivec2(floor((r.st * 0.5 + 0.5) * shadow_extent.x));
  return lit_at(r, clamp(texel, ivec2(0), ivec2(shadow_extent.x) - 1));
}
#endif
#endif
