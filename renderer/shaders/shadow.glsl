// Visibility of the light from a point, by the map. Needs gbuffer.glsl and light.glsl.
layout(binding = 8) uniform sampler2DArray shadow_map;

struct Receiver {
  vec3 d;       // from shadow_origin
  vec3 normal;  // of its plane
  int view;
  vec2 st;      // -1..1 over the map
  float depth;  // along the view
};

Receiver receiver_at(vec3 position, float z, vec3 geometric_normal) {
  Receiver r;
  r.d = position - shadow_origin.xyz;
  r.normal = geometric_normal;
  r.view = shadow_view_of(r.d, z);
  vec3 q = to_shadow_view(r.view, r.d);
  r.st = q.xy;
  r.depth = q.z;
  return r;
}

#ifdef SHADOW_ESM
// The map holds blurred occluder depths, divided by the light's range as the receiver's are.
float visibility_in_view(Receiver r, float n_dot_l) {
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
// The depths that a map would store for the receiver's plane: an affine function of the map position, so that a plane
// never shadows itself, at any angle and resolution.
struct PlaneDepth {
  float at_receiver;
  vec2 slope;  // change per unit of st
  float bias;
};

PlaneDepth plane_depth(Receiver r) {
  ShadowView v = shadow_views[r.view];
  vec3 right = v.right.xyz / dot(v.right.xyz, v.right.xyz);
  vec3 up = v.up.xyz / dot(v.up.xyz, v.up.xyz);
  float texel = 2.0 * shadow_extent.y * max(length(right), length(up));
  // What rounding may have moved the receiver off its plane, by its distances from the camera, the light and the origin.
  vec3 position = r.d + shadow_origin.xyz;
  float rounding = 1e-6 * (distance(position, camera_position.xyz) + length(r.d)) + 2e-7 * length(position);
  vec2 across = vec2(dot(r.normal, right), dot(r.normal, up));
  PlaneDepth plane;
#ifdef SHADOW_ORTHOGRAPHIC
  float along = dot(r.normal, v.forward.xyz);
  along = abs(along) < 1e-4 ? 1e-4 : along;
  plane.at_receiver = 1.0 - r.depth / shadow_origin.w;
  plane.slope = across / (along * shadow_origin.w);
  plane.bias = (shadow_bias * texel + rounding / abs(along)) / shadow_origin.w;
#else
  float along = dot(r.normal, r.d) / r.depth;
  along = abs(along) < 1e-4 ? 1e-4 : along;
  plane.at_receiver = shadow_origin.w / r.depth;
  plane.slope = plane.at_receiver * across / along;
  plane.bias = plane.at_receiver * (shadow_bias * texel + rounding / (abs(along) * r.depth));
#endif
  return plane;
}

float lit_at(Receiver r, PlaneDepth plane, ivec2 texel) {
  vec2 offset = (vec2(texel) + 0.5) * shadow_extent.y * 2.0 - 1.0 - r.st;
  float occluder = texelFetch(shadow_map, ivec3(texel, r.view), 0).r;
  return occluder > plane.at_receiver + dot(plane.slope, offset) + plane.bias ? 0.0 : 1.0;
}

#ifdef SHADOW_PCF
float visibility_in_view(Receiver r, float n_dot_l) {
  vec2 texel = (r.st * 0.5 + 0.5) * shadow_extent.x - 0.5;
  ivec2 corner = ivec2(floor(texel));
  vec2 f = texel - vec2(corner);
  PlaneDepth plane = plane_depth(r);
  float sum = 0.0;
  float weights = 0.0;
  for (int y = -pcf_radius; y <= pcf_radius + 1; ++y)
    for (int x = -pcf_radius; x <= pcf_radius + 1; ++x) {
      // A box of (2r+1) texels slides over the map: its ends count in part.
      vec2 weight = vec2(x == -pcf_radius ? 1.0 - f.x : (x == pcf_radius + 1 ? f.x : 1.0),
                         y == -pcf_radius ? 1.0 - f.y : (y == pcf_radius + 1 ? f.y : 1.0));
      ivec2 at = clamp(corner + ivec2(x, y), ivec2(0), ivec2(shadow_extent.x) - 1);
      sum += weight.x * weight.y * lit_at(r, plane, at);
      weights += weight.x * weight.y;
    }
  return sum / weights;
}
#else
float visibility_in_view(Receiver r, float n_dot_l) {
  ivec2 texel = ivec2(floor((r.st * 0.5 + 0.5) * shadow_extent.x));
  return lit_at(r, plane_depth(r), clamp(texel, ivec2(0), ivec2(shadow_extent.x) - 1));
}
#endif
#endif

float visibility(Receiver r, float n_dot_l) {
  // A view in which nothing was seen was not drawn; rounding may still put a point of a seam there.
  return shadow_views[r.view].forward.w == 0.0 ? 1.0 : visibility_in_view(r, n_dot_l);
}
