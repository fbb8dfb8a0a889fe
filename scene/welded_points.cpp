#include "scene/welded_points.h"

#include <bit>

#include "scene/index_table.h"

namespace lightbench {

WeldedPoints weld(const std::vector<glm::vec3>& positions) {
  WeldedPoints result;
  result.point_of_position.reserve(positions.size());
  IndexTable table(positions.size());
  for (const glm::vec3& p : positions) {
    const glm::vec3 q = p + 0.0f;  // -0 becomes 0
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k) hash = mix_hash(hash, std::bit_cast<std::uint32_t>(q[k]));
    const auto next = std::uint32_t(result.points.size());
    const std::uint32_t point =
        table.find_or_insert(hash, next, [&](std::uint32_t i) { return result.points[i] == q; });
    if (point == next) result.points.push_back(q);
    result.point_of_position.push_back(point);
  }
  return result;
}

}  // namespace lightbench
