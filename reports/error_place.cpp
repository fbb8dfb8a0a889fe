#include "reports/error_place.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "reports/metrics/pixel_error.h"
#include "reports/value_text.h"

namespace lightbench {
namespace {

/// Finds the pixels that are joined to the place's, and the box around them.
void grow_region(const Image8& a, const Image8& b, ErrorPlace& place) {
  const int least = (place.largest + 1) / 2;
  std::vector<bool> seen(a.pixel_count());
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= a.width || y >= a.height) return;
    const std::size_t pixel = std::size_t(y) * std::size_t(a.width) + std::size_t(x);
    if (seen[pixel] || pixel_error(a, b, pixel) < least) return;
    seen[pixel] = true;
    open.emplace_back(x, y);
  };
  int left = place.x, right = place.x, top = place.y, bottom = place.y;
  visit(place.x, place.y);
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    ++place.region_pixels;
    left = std::min(left, x), right = std::max(right, x);
    top = std::min(top, y), bottom = std::max(bottom, y);
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) visit(x + dx, y + dy);
  }
  place.region = {left, top, right - left + 1, bottom - top + 1};
}

/// "x 3 to 14, y 20 to 31".
std::string box_text(const PixelBox& box) {
  return fmt::format("x {} to {}, y {} to {}", box.x, box.x + box.width - 1, box.y, box.y + box.height - 1);
}

}  // namespace

std::optional<ErrorPlace> find_error(const Image8& a, const Image8& b) {
  ErrorPlace place;
  for (std::size_t pixel = 0; pixel < a.pixel_count(); ++pixel) {
    const int error = pixel_error(a, b, pixel);
    if (error > 0) ++place.differing;
    if (error <= place.largest) continue;
    place.largest = error;
    place.x = int(pixel % std::size_t(a.width));
    place.y = int(pixel / std::size_t(a.width));
  }
  if (place.differing == 0) return std::nullopt;
  grow_region(a, b, place);
  place.block = worst_block(a, b);
  return place;
}

std::string error_place_text(const std::optional<ErrorPlace>& place) {
  if (!place) return "no pixel differs in colour\n";
  return fmt::format(
      "{} {} in colour (x and y are counted from the top left corner, from 0):\n"
      "  largest error {} of 255 at x {}, y {}; {} around it with at least half of that at {}\n"
      "  worst block of {} x {} pixels at {}, with a mean error of {:.3f} of 255\n",
      counted(place->differing, "pixel"), place->differing == 1 ? "differs" : "differ", place->largest,
      place->x, place->y, counted(place->region_pixels, "pixel"), box_text(place->region),
      place->block.box.width, place->block.box.height, box_text(place->block.box), place->block.mean_error);
}

}  // namespace lightbench
