#include "reports/metrics/block_error.h"

#include <algorithm>
#include <cstdlib>

namespace lightbench {
namespace {

/// Adds a row's errors to the sums of its columns, or takes them off.
template <int kSign>
void add_row(const Image8& a, const Image8& b, int y, std::vector<int>& columns) {
  const std::size_t begin = 3 * std::size_t(y) * std::size_t(a.width);
  const std::uint8_t* p = a.data.data() + begin;
  const std::uint8_t* q = b.data.data() + begin;
  for (std::size_t x = 0; x < columns.size(); ++x, p += 3, q += 3)
    columns[x] += kSign * (std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]));
}

}  // namespace

WorstBlock worst_block(const Image8& a, const Image8& b) {
  const int width = std::min(kBlockSide, a.width), height = std::min(kBlockSide, a.height);
  std::vector<int> columns(std::size_t(a.width));  // sums over the rows of the block
  int largest = -1;
  PixelBox box{0, 0, width, height};
  for (int y = 0; y < a.height; ++y) {
    add_row<1>(a, b, y, columns);
    if (y >= height) add_row<-1>(a, b, y - height, columns);
    if (y < height - 1) continue;
    int sum = 0;
    for (int x = 0; x < a.width; ++x) {
      sum += columns[std::size_t(x)];
      if (x >= width) sum -= columns[std::size_t(x - width)];
      if (x < width - 1 || sum <= largest) continue;
      largest = sum;
      box.x = x - width + 1;
      box.y = y - height + 1;
    }
  }
  return {box, largest / (3.0 * width * height)};
}

MetricValue block_error(const MetricInput& input) {
  return MetricValue::of(worst_block(input.reference, input.image).mean_error);
}

}  // namespace lightbench
