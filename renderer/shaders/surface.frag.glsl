#include "shaders/frame.glsl"
#include "shaders/material.glsl"
#include "shaders/octahedral.glsl"
#ifdef CUTOUT
#include "shaders/cutout.glsl"
#endif

layout(location = 0) in vec3 relative_position;
layout(location = 1) in vec3 world_normal;
layout(location = 2) in vec2 surface_uv;
layout(location = 3) in vec3 surface_color;

layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 normal;
layout(location = 2) out float depth;
layout(location = 3) out vec2 specular;
layout(location = 4) out vec2 geometric_normal;
layout(location = 5) out vec4 emission;
#ifdef WITH_ENTITIES
layout(location = 6) out float entity_number;  // from 1 on
uniform int entity;
#endif
#ifdef WITH_CEILING
uniform float ceiling;  // relative to the camera; what is higher is left out
#endif

// A normal that faces away from the viewer is turned over; without a direction, the other one stands in.
vec3 towards_viewer(vec3 n, vec3 otherwise) {
  float size = length(n);
  n = size > 0.0 ? n / size : otherwise;
  return dot(n, relative_position) > 0.0 ? -n : n;
}

vec4 encoded_normal(vec3 n) {
#ifdef NORMALS_RGB8
  return vec4(n * 0.5 + 0.5, 1.0);
#else
  return vec4(encode_octahedral(n), 0.0, 1.0);
#endif
}

#ifdef BEHIND_LAYER
// What was drawn nearer to the viewer already, as `depth` has it; and where this layer's texels lie from its own.
layout(binding = 2) uniform sampler2D nearer_layer;
uniform ivec2 nearer_offset;
// By how much, as a share, a surface has to lie behind it to be another one.
const float kBehind = 1e-3;
#endif

void main() {
  Material material = materials[material_index];
  // Derivatives and texture lookups first: they need all pixels of a block to take part.
  vec3 face_normal = cross(dFdx(relative_position), dFdy(relative_position));
  vec3 diffuse = surface_diffuse(surface_uv, surface_color);
#ifdef CUTOUT
  if (is_cut_out(surface_uv)) discard;
#endif
#ifdef WITH_CEILING
  if (relative_position.y > ceiling) discard;
#endif

  float kept_depth = dot(relative_position, camera_forward.xyz) / camera_position.w;
#ifdef BEHIND_LAYER
  float nearer = texelFetch(nearer_layer, ivec2(gl_FragCoord.xy) + nearer_offset, 0).r;
  if (nearer <= 0.0 || kept_depth <= nearer * (1.0 + kBehind)) discard;
#ifdef FRONT_FACES
  if (dot(world_normal, relative_position) > 0.0) discard;
#endif
#endif

  vec3 viewer = -normalize(relative_position);
  face_normal = towards_viewer(face_normal, viewer);
  albedo = vec4(diffuse, material.diffuse_reflectance.a);
  normal = encoded_normal(towards_viewer(world_normal, face_normal));
  geometric_normal = encode_octahedral(face_normal);
  depth = kept_depth;
  specular = vec2(material.emission_specular.a, material.exponent_texture.x);
  emission = vec4(material.emission_specular.rgb, 1.0);
#ifdef WITH_ENTITIES
  entity_number = float(entity + 1);
#endif
}
