// Pieces of lines along the order of a texel's directions (renderer/radiance/piecewise.h).
layout(binding = 2) uniform usamplerBuffer starts;         // of each texel: its first sample
layout(binding = 3) uniform usamplerBuffer sample_layers;  // of each sample
layout(binding = 4) uniform usamplerBuffer color_indices;  // of each sample, where `mapped`
layout(binding = 5) uniform usamplerBuffer colors;         // of each index, or of each sample

uniform int samples;  // of all texels
uniform bool mapped;

int layer_at(int sample_index) { return int(texelFetch(sample_layers, sample_index).r); }

ivec3 color_at(int sample_index) {
  int place = mapped ? int(texelFetch(color_indices, sample_index).r) : sample_index;
  return ivec3(texelFetch(colors, place).rgb);
}

// The last sample in [first, end) whose layer is not above the one that is asked for; that of `first` is not.
int search(int first, int end, int layer) {
#ifdef SEARCH_LINEAR
  int found = first;
  while (found + 1 < end && layer_at(found + 1) <= layer) ++found;
  return found;
#else
  int low = first, high = end;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (layer_at(middle) <= layer) low = middle; else high = middle;
  }
  return low;
#endif
}

vec3 linear_from_srgb(ivec3 bytes) {
  vec3 encoded = vec3(bytes) / 255.0;
  return mix(pow((encoded + 0.055) / 1.055, vec3(2.4)), encoded / 12.92, lessThanEqual(encoded, vec3(0.04045)));
}

// In whole numbers, so that it is what the encoder bounded.
vec3 color_of(int found, int end, int layer) {
  ivec3 a = color_at(found);
  if (found + 1 == end) return linear_from_srgb(a);
  int i = layer_at(found), j = layer_at(found + 1);
  ivec3 b = color_at(found + 1);
  return linear_from_srgb((a * (j - layer) + b * (layer - i) + (j - i) / 2) / (j - i));
}

// Of two layers, mixed.
vec3 pair_of(int first, int end, int layer, int other, float part) {
#ifdef SEARCH_ONCE
  int low = min(layer, other), high = max(layer, other);
  int found = search(first, end, low);
  vec3 lower = color_of(found, end, low);
  while (found + 1 < end && layer_at(found + 1) <= high) ++found;
  vec3 upper = color_of(found, end, high);
  return layer <= other ? mix(lower, upper, part) : mix(upper, lower, part);
#else
  return mix(color_of(search(first, end, layer), end, layer), color_of(search(first, end, other), end, other), part);
#endif
}

vec3 texel_radiance(ivec2 place, NearestDirections near) {
  int texel = place.y * size.x + place.x;
  int first = int(texelFetch(starts, texel).r);
  int end = texel + 1 < size.x * size.y ? int(texelFetch(starts, texel + 1).r) : samples;
  // Pairs are neighbours in the order of layers.
#ifdef THETA_MAJOR
  return mix(pair_of(first, end, layer_of(near.theta.x, near.phi.x), layer_of(near.theta.x, near.phi.y), near.part.y),
             pair_of(first, end, layer_of(near.theta.y, near.phi.x), layer_of(near.theta.y, near.phi.y), near.part.y),
             near.part.x);
#else
  return mix(pair_of(first, end, layer_of(near.theta.x, near.phi.x), layer_of(near.theta.y, near.phi.x), near.part.x),
             pair_of(first, end, layer_of(near.theta.x, near.phi.y), layer_of(near.theta.y, near.phi.y), near.part.x),
             near.part.y);
#endif
}

vec3 radiance(vec2 texel, NearestDirections near) {
  vec2 corner = texel - 0.5;
  ivec2 low = clamp(ivec2(floor(corner)), ivec2(0), size - 1);
  ivec2 high = min(low + 1, size - 1);
  vec2 part = clamp(corner - vec2(low), 0.0, 1.0);
  return mix(mix(texel_radiance(low, near), texel_radiance(ivec2(high.x, low.y), near), part.x),
             mix(texel_radiance(ivec2(low.x, high.y), near), texel_radiance(high, near), part.x), part.y);
}
