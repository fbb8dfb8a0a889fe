// As pca.glsl, with corrections that bound the error of each texel in each direction. So these are decoded one by one,
// by the sums that the bound was made for, and then mixed as in piecewise.glsl, in linear light.
layout(binding = 2) uniform sampler2DArray mean;               // one layer, of directions
layout(binding = 3) uniform sampler2DArray basis;              // three layers for each four coefficients
layout(binding = 4) uniform sampler2DArray wide;               // coefficients by four, of texels
layout(binding = 5) uniform sampler2DArray narrow;             // likewise
layout(binding = 6) uniform usamplerBuffer blocks;             // of each compressed coefficient and 4 x 4 texels
layout(binding = 7) uniform usamplerBuffer first_corrections;  // of each 4 x 4 texels; at the end the number of all
layout(binding = 8) uniform usamplerBuffer corrections;
layout(std430, binding = 3) readonly buffer Lines { vec2 lines[]; };  // of each coefficient: offset, step

uniform vec2 mean_line;
uniform ivec2 groups;         // of four coefficients, in `wide` and in `narrow`
uniform int compressed;       // coefficients
uniform int correction_step;  // 0: there are none

// Of a direction, theta and phi, in `mean` and `basis`. A matte object has but one.
ivec2 place_of(ivec2 direction) { return min(direction.yx, textureSize(mean, 0).xy - 1); }

float mean_of(ivec2 direction, int component) {
  precise float value = round(65535.0 * texelFetch(mean, ivec3(place_of(direction), 0), 0)[component]);
  value = mean_line.x + mean_line.y * value;
  return value;
}

int blocks_across() { return (size.x + 3) / 4; }
int block_of(ivec2 texel) { return texel.y / 4 * blocks_across() + texel.x / 4; }
int place_in_block(ivec2 texel) { return texel.y % 4 * 4 + texel.x % 4; }

// Number `place` of a block (renderer/radiance/rgtc.h): OpenGL does not say how it rounds those of its own.
float decode_rgtc(uvec2 block, int place) {
  int shift = 16 + 3 * place;
  uint code = (shift < 32 ? block.x >> shift | block.y << (32 - shift) : block.y >> (shift - 32)) & 7u;
  int sevenths = code == 0u ? 0 : code == 1u ? 7 : int(code) - 1;
  ivec2 ends = ivec2(block.xx >> uvec2(0, 8) & 255u);
  return float((ends.x * (7 - sevenths) + ends.y * sevenths + 3) / 7);
}

// Four coefficients of a texel, in whole numbers.
vec4 stored_of(int group, ivec2 texel) {
  if (group < groups.x) return round(65535.0 * texelFetch(wide, ivec3(texel, group), 0));
  group -= groups.x;
  if (group < groups.y) return round(255.0 * texelFetch(narrow, ivec3(texel, group), 0));
  vec4 stored = vec4(0.0);
  int block_count = blocks_across() * ((size.y + 3) / 4);
  for (int i = 0, k = 4 * (group - groups.y); i < 4 && k < compressed; ++i, ++k)
    stored[i] = decode_rgtc(texelFetch(blocks, 2 * (k / 2 * block_count + block_of(texel)) + k % 2).xy,
                            place_in_block(texel));
  return stored;
}

vec4 weights_of(int group, ivec2 texel) {
  precise vec4 weights = stored_of(group, texel);
  for (int i = 0; i < 4; ++i) {
    vec2 line = 4 * group + i < lines.length() ? lines[4 * group + i] : vec2(0.0);
    weights[i] = line.x + line.y * weights[i];
  }
  return weights;
}

// The shares of (x, y), (x + 1, y), (x, y + 1), (x + 1, y + 1) at a place between them.
vec4 corner_parts(vec2 part) { return vec4(1.0 - part.x, part.x, 1.0 - part.x, part.x) * vec4(1.0 - part.yy, part.yy); }

// A value that is rounded, with the corrections of its key: its block's rise by key.
ivec3 corrected(ivec3 value, int block, uint key) {
  int low = int(texelFetch(first_corrections, block).r), end = int(texelFetch(first_corrections, block + 1).r);
  for (int high = end; low < high;) {
    int middle = (low + high) / 2;
    if ((texelFetch(corrections, middle).r & 0xfffffu) < key) low = middle + 1; else high = middle;
  }
  for (; low < end; ++low) {
    uint correction = texelFetch(corrections, low).r;
    if ((correction & 0xfffffu) != key) break;
    value = clamp(value + correction_step * (ivec3(uvec3(correction) >> uvec3(20, 24, 28) & 15u) - 8), 0, 255);
  }
  return value;
}

// Adds four coefficients' products to the sums of four texels. Coefficients come one after another, since the order
// decides how sums are rounded.
void add_group(int group, ivec2 texels[4], ivec2 directions[4], inout vec4 sums[12]) {
  mat4 weights;
  for (int i = 0; i < 4; ++i) weights[i] = weights_of(group, texels[i]);
  weights = transpose(weights);
  for (int i = 0; i < 12; ++i) {
    ivec3 place = ivec3(place_of(directions[i / 3]), 3 * group + i % 3);
    vec4 functions = round(32767.0 * texelFetch(basis, place, 0));
    precise vec4 sum = sums[i];
    for (int k = 0; k < 4; ++k) sum += weights[k] * functions[k];
    sums[i] = sum;
  }
}

// In loops, since compilers take minutes over all of it side by side.
vec3 radiance(vec2 texel, NearestDirections near) {
  vec2 corner = texel - 0.5;
  ivec2 low = clamp(ivec2(floor(corner)), ivec2(0), size - 1);
  ivec2 high = min(low + 1, size - 1);
  ivec2 texels[4] = ivec2[](low, ivec2(high.x, low.y), ivec2(low.x, high.y), high);
  vec4 texel_parts = corner_parts(clamp(corner - vec2(low), 0.0, 1.0));
  ivec2 directions[4] = ivec2[](ivec2(near.theta.x, near.phi.x), ivec2(near.theta.y, near.phi.x),
                                ivec2(near.theta.x, near.phi.y), ivec2(near.theta.y, near.phi.y));
  vec4 direction_parts = corner_parts(near.part);

  vec4 sums[12];  // of each direction three components, of the four texels
  for (int i = 0; i < 12; ++i) sums[i] = vec4(mean_of(directions[i / 3], i % 3));
  for (int group = 0; 4 * group < lines.length(); ++group) add_group(group, texels, directions, sums);

  vec3 light = vec3(0.0);
  for (int i = 0; i < 16; ++i) {
    int t = i % 4, d = i / 4;
    vec3 sum = vec3(sums[3 * d][t], sums[3 * d + 1][t], sums[3 * d + 2][t]);
    ivec3 value = ivec3(clamp(sum, 0.0, 255.0) + 0.5);
    uint key = uint(16 * layer_of(directions[d].x, directions[d].y) + place_in_block(texels[t]));
    if (correction_step > 0) value = corrected(value, block_of(texels[t]), key);
    light += texel_parts[t] * direction_parts[d] * linear_from_srgb(vec3(value) / 255.0);
  }
  return light;
}
