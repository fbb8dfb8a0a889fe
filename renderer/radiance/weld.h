#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace lightbench {

/// For each of `count` vertices, the first one with the same key: the N floats that `key` makes of an index.
/// 0 and -0 are the same, and any NaN is the same as itself.
template <std::size_t N, typename Key>
std::vector<std::uint32_t> weld(std::size_t count, const Key& key) {
  std::vector<std::pair<std::array<std::uint32_t, N>, std::uint32_t>> order(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::array<float, N> floats = key(i);
    for (std::size_t k = 0; k < N; ++k) order[i].first[k] = std::bit_cast<std::uint32_t>(floats[k] + 0.0f);
    order[i].second = i;
  }
  std::ranges::sort(order);
  std::vector<std::uint32_t> first(count);
  for (std::size_t i = 0; i < count; ++i) {
    const bool again = i > 0 && order[i].first == order[i - 1].first;
    first[order[i].second] = again ? first[order[i - 1].second] : order[i].second;
  }
  return first;
}

/// The same of positions.
inline std::vector<std::uint32_t> weld_positions(const std::vector<glm::vec3>& positions) {
  return weld<3>(positions.size(), [&](std::uint32_t i) {
    return std::array{positions[i].x, positions[i].y, positions[i].z};
  });
}

}  // namespace lightbench
