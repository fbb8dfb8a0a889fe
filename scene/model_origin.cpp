#include "scene/model_origin.h"

#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace lightbench {

glm::dvec3 model_origin(const ObjData& data) {
  glm::dvec3 min(std::numeric_limits<double>::max());
  glm::dvec3 max(std::numeric_limits<double>::lowest());
  for (const ObjFace& face : data.faces)
    for (std::uint32_t i = face.first_corner; i < face.first_corner + face.corner_count; ++i) {
      const glm::dvec3& p = data.positions[std::size_t(data.corners[i].position)];
      min = glm::min(min, p);
      max = glm::max(max, p);
    }
  const double size = glm::length(max - min);
  const glm::dvec3 center = 0.5 * (min + max);
  if (data.faces.empty() || !(size > 0) || glm::length(center) <= kFarAway * size) return glm::dvec3(0);
  // A multiple of a power of two, so that subtracting it rounds as little as can be.
  const double step = std::exp2(std::floor(std::log2(size)));
  return glm::round(center / step) * step;
}

}  // namespace lightbench
