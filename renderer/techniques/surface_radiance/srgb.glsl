// Linear light of sRGB-encoded values, 0..1.
vec3 linear_from_srgb(vec3 encoded) {
  return mix(pow((encoded + 0.055) / 1.055, vec3(2.4)), encoded / 12.92, lessThanEqual(encoded, vec3(0.04045)));
}
