// The grid of directions in which radiance is kept (renderer/radiance/direction_grid.h).
uniform ivec2 grid;  // thetas, phis

// What takes (0, 1, 0) to the normal, as its transpose: world to local.
mat3 local_from_world(vec3 n) {
  float across = n.x * n.x + n.z * n.z;
  if (n.y < 0.0 && across < 1e-12) return mat3(1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0);
  float k = n.y < 0.0 ? (1.0 - n.y) / across : 1.0 / (1.0 + n.y);
  return transpose(mat3(1.0 - k * n.x * n.x, -n.x, -k * n.x * n.z, n, -k * n.x * n.z, -n.z, 1.0 - k * n.z * n.z));
}

// The four directions around one, and the share of the upper ones.
struct NearestDirections {
  ivec2 theta, phi;
  vec2 part;  // theta, phi
};

const float kPi = 3.14159265358979;

NearestDirections nearest_directions(vec3 local) {
  float across = length(local.xz);
  float theta = atan(across, local.y) * float(grid.x - 1) / (0.5 * kPi);
  float turn = across > 0.0 ? atan(local.z, local.x) / (2.0 * kPi) : 0.0;
  float phi = (turn < 0.0 ? turn + 1.0 : turn) * float(grid.y);
  NearestDirections nearest;
  nearest.theta.x = clamp(int(theta), 0, grid.x - 1);
  nearest.theta.y = min(nearest.theta.x + 1, grid.x - 1);
  nearest.phi.x = int(phi) % grid.y;
  nearest.phi.y = (nearest.phi.x + 1) % grid.y;
  nearest.part = clamp(vec2(theta - float(nearest.theta.x), phi - float(int(phi))), 0.0, 1.0);
  return nearest;
}

// The place of a direction in the order of layers.
int layer_of(int theta, int phi) {
#if defined(THETA_MAJOR)
  return theta * grid.y + phi;
#elif defined(PHI_MAJOR)
  return phi * grid.x + theta;
#else
  return phi * grid.x + (phi % 2 == 1 ? grid.x - 1 - theta : theta);
#endif
}
