#include "scene/transform.h"

#include <cmath>

#include <glm/trigonometric.hpp>

namespace lightbench {
namespace {

double cosine_degrees(double degrees) {
  const double turned = std::fmod(std::abs(degrees), 360.0);
  if (turned == 90 || turned == 270) return 0;
  if (turned == 180) return -1;
  return std::cos(glm::radians(turned));
}
double sine_degrees(double degrees) {
  return cosine_degrees(degrees - 90.0);
}

// Rotation about axis 0, 1 or 2.
glm::dmat4 rotation(int axis, double degrees) {
  const int u = (axis + 1) % 3;
  const int v = (axis + 2) % 3;
  glm::dmat4 m(1);
  m[u][u] = m[v][v] = cosine_degrees(degrees);
  m[u][v] = sine_degrees(degrees);
  m[v][u] = -m[u][v];
  return m;
}

}  // namespace

glm::dmat4 rotation_degrees(const glm::dvec3& degrees) {
  return rotation(2, degrees.z) * rotation(1, degrees.y) * rotation(0, degrees.x);
}

}  // namespace lightbench
