// What surfaces are made of (renderer/gpu_scene.h).
layout(binding = 0) uniform sampler2D diffuse_texture;

struct Material {
  vec4 diffuse_reflectance;
  vec4 emission_specular;
  vec4 exponent_texture;  // exponent, has a diffuse texture, unused, unused
};
layout(std430, binding = 0) readonly buffer Materials { Material materials[]; };
uniform int material_index;

// Linear. To be called before any discard: texture lookups need all pixels of a block to take part.
vec3 surface_diffuse(vec2 uv, vec3 vertex_color) {
  Material material = materials[material_index];
  vec3 diffuse = material.diffuse_reflectance.rgb * vertex_color;
  if (material.exponent_texture.y != 0.0) diffuse *= texture(diffuse_texture, uv).rgb;
  return diffuse;
}
