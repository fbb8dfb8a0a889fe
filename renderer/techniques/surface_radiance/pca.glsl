// Weighted sums of functions of the direction (renderer/radiance/pca.h). The hardware interpolates weights between
// texels and functions between directions: between texels and directions that is done in encoded values.
layout(binding = 2) uniform sampler2DArray mean;    // one layer, of directions
layout(binding = 3) uniform sampler2DArray basis;   // three layers for each four coefficients
layout(binding = 4) uniform sampler2DArray wide;    // coefficients by four, of texels
layout(binding = 5) uniform sampler2DArray narrow;  // likewise
layout(binding = 6) uniform sampler2DArray blocks;  // coefficients by two
layout(std430, binding = 3) readonly buffer Ranges { vec2 ranges[]; };  // of each coefficient: offset, scale

uniform vec2 mean_range;
uniform ivec2 groups;    // of four coefficients, in `wide` and in `narrow`
uniform int compressed;  // coefficients, in `blocks`

// What four coefficients, from number 4 group on, add: `stored` as the texture has them.
vec3 group_of(int group, vec4 stored, vec2 direction) {
  vec4 offset, scale;
  for (int i = 0; i < 4; ++i) {
    vec2 range = 4 * group + i < ranges.length() ? ranges[4 * group + i] : vec2(0.0);
    offset[i] = range.x;
    scale[i] = range.y;
  }
  vec4 weights = offset + scale * stored;
  return vec3(dot(weights, texture(basis, vec3(direction, 3 * group))),
              dot(weights, texture(basis, vec3(direction, 3 * group + 1))),
              dot(weights, texture(basis, vec3(direction, 3 * group + 2))));
}

vec3 radiance(vec2 texel, NearestDirections near) {
  vec2 at = texel / vec2(size);
  // Matte objects have one direction, wherever it is looked up.
  vec2 direction = (vec2(near.phi.x, near.theta.x) + near.part.yx + 0.5) / vec2(grid.yx);
  vec3 encoded = mean_range.x + mean_range.y * texture(mean, vec3(direction, 0.0)).rgb;
  for (int i = 0; i < groups.x; ++i) encoded += group_of(i, texture(wide, vec3(at, i)), direction);
  for (int i = 0; i < groups.y; ++i) encoded += group_of(groups.x + i, texture(narrow, vec3(at, i)), direction);
  int pairs = compressed / 2;
  for (int i = 0; i < pairs; i += 2) {
    vec2 second = i + 1 < pairs ? texture(blocks, vec3(at, i + 1)).rg : vec2(0.0);
    encoded += group_of(groups.x + groups.y + i / 2, vec4(texture(blocks, vec3(at, i)).rg, second), direction);
  }
  return linear_from_srgb(clamp(encoded / 255.0, 0.0, 1.0));
}
