// Unit vectors as two numbers in 0..1 on an octahedron unfolded into a square. The grid is such that 16-bit
// unsigned normalised storage keeps 0 and +-1 exactly.
const float kOctahedralScale = 32767.0 / 65535.0;

vec2 encode_octahedral(vec3 n) {
  n /= abs(n.x) + abs(n.y) + abs(n.z);
  vec2 p = n.xy;
  if (n.z < 0.0)
    p = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
  return (p + 1.0) * kOctahedralScale;
}

vec3 decode_octahedral(vec2 stored) {
  vec2 p = stored / kOctahedralScale - 1.0;
  vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
  if (n.z < 0.0)
    n.xy = (1.0 - abs(n.yx)) * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
  return normalize(n);
}
