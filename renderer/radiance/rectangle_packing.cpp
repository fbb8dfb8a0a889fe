#include "renderer/radiance/rectangle_packing.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

#include <glm/common.hpp>

namespace lightbench {

RectanglePacking pack_on_shelves(std::span<const glm::ivec2> sizes, int width) {
  std::vector<std::uint32_t> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](std::uint32_t i, std::uint32_t j) {
    return sizes[i].y != sizes[j].y ? sizes[i].y > sizes[j].y : sizes[i].x > sizes[j].x;
  });
  RectanglePacking packing;
  packing.places.resize(sizes.size());
  std::multimap<int, int> shelves;  // room left -> y
  for (const std::uint32_t i : order) {
    assert(sizes[i].x <= width);
    auto shelf = shelves.lower_bound(sizes[i].x);
    if (shelf == shelves.end()) {
      shelf = shelves.emplace(width, packing.size.y);
      packing.size.y += sizes[i].y;
    }
    const auto [room, y] = *shelf;
    shelves.erase(shelf);
    packing.places[i] = {width - room, y};
    packing.size.x = std::max(packing.size.x, width - room + sizes[i].x);
    if (room > sizes[i].x) shelves.emplace(room - sizes[i].x, y);
  }
  return packing;
}

RectanglePacking pack_about_square(std::span<const glm::ivec2> sizes) {
  double area = 0;
  int widest = 1;
  for (const glm::ivec2& size : sizes) {
    area += double(size.x) * size.y;
    widest = std::max(widest, size.x);
  }
  // Too narrow a strip is higher than wide; the height falls as the width grows.
  int width = std::max(widest, int(std::ceil(std::sqrt(area))));
  RectanglePacking packing = pack_on_shelves(sizes, width);
  while (packing.size.y > width) {
    width += std::max(1, (packing.size.y - width) / 3);
    packing = pack_on_shelves(sizes, width);
  }
  return packing;
}

}  // namespace lightbench
