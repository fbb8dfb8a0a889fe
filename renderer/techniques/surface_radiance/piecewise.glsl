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

// In whole numbers, so that it is what the encoder bounded.
vec3 color_of(int found, int end, int layer) {
  ivec3 a = color_at(found);
  if (found + 1 == end) return linear_from_srgb(vec3(a) / 255.0);
  int i = layer_at(found), j = layer_at(found + 1);
  ivec3 b = color_at(found + 1);
  return linear_from_srgb(vec3((a * (j - layer) + b * (layer - i) + (j - i) / 2) / (j - i)) / 255.0);
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

// The eight pairs around a place, in a loop, since compilers take minutes over all of them side by side. Pairs are
// neighbours in the order of layers.
vec3 radiance(vec2 texel, NearestDirections near) {
  vec2 corner = texel - 0.5;
  ivec2 low = clamp(ivec2(floor(corner)), ivec2(0), size - 1);
  ivec2 high = min(low + 1, size - 1);
  vec2 part = clamp(corner - vec2(low), 0.0, 1.0);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 8; ++i) {
    bvec3 upper = bvec3(i & 1, i & 2, i & 4);  // texel along x, along y, pair
    ivec2 place = ivec2(upper.x ? high.x : low.x, upper.y ? high.y : low.y);
    int index = place.y * size.x + place.x;
    int first = int(texelFetch(starts, index).r);
    int end = index + 1 < size.x * size.y ? int(texelFetch(starts, index + 1).r) : samples;
#ifdef THETA_MAJOR
    int theta = upper.z ? near.theta.y : near.theta.x;
    vec3 color = pair_of(first, end, layer_of(theta, near.phi.x), layer_of(theta, near.phi.y), near.part.y);
    float pair_part = near.part.x;
#else
    int phi = upper.z ? near.phi.y : near.phi.x;
    vec3 color = pair_of(first, end, layer_of(near.theta.x, phi), layer_of(near.theta.y, phi), near.part.x);
    float pair_part = near.part.y;
#endif
    vec3 parts = mix(1.0 - vec3(part, pair_part), vec3(part, pair_part), upper);
    sum += parts.x * parts.y * parts.z * color;
  }
  return sum;
}
