#include "renderer/radiance/rgtc.h"

#include <algorithm>
#include <cmath>

namespace lightbench {
namespace {

/// How many sevenths of the way from the first end to the second a code stands for, and the other way round.
constexpr std::array<int, 8> kSevenths{0, 7, 1, 2, 3, 4, 5, 6};
constexpr std::array<int, 8> kCodes{0, 2, 3, 4, 5, 6, 7, 1};

/// The first end is above the second, or there is but one number.
struct Ends {
  int first, second;

  int number(int sevenths) const { return (first * (7 - sevenths) + second * sevenths + 3) / 7; }
  int nearest(float number) const {
    if (first == second) return 0;
    const float way = (float(first) - number) / float(first - second);
    return std::clamp(int(std::lround(7 * way)), 0, 7);
  }
};

template <typename Handle>
void for_counted(std::uint32_t counts, const Handle& handle) {
  for (int i = 0; i < 16; ++i)
    if (counts >> i & 1) handle(i);
}

float squared_error(const Ends& ends, const std::array<float, 16>& numbers, std::uint32_t counts) {
  float sum = 0;
  for_counted(counts, [&](int i) {
    const float number = numbers[std::size_t(i)];
    const float error = number - float(ends.number(ends.nearest(number)));
    sum += error * error;
  });
  return sum;
}

Ends ordered(float a, float b) {
  const auto end = [](float v) { return int(std::lround(std::clamp(v, 0.0f, 255.0f))); };
  return {end(std::max(a, b)), end(std::min(a, b))};
}

Ends outermost(const std::array<float, 16>& numbers, std::uint32_t counts) {
  float least = 255, most = 0;
  for_counted(counts, [&](int i) {
    least = std::min(least, numbers[std::size_t(i)]), most = std::max(most, numbers[std::size_t(i)]);
  });
  return least > most ? Ends{0, 0} : ordered(most, least);
}

/// The ends of least squared error while all numbers keep their codes.
Ends refitted(const Ends& ends, const std::array<float, 16>& numbers, std::uint32_t counts) {
  float aa = 0, ab = 0, bb = 0, ax = 0, bx = 0;
  for_counted(counts, [&](int i) {
    const float number = numbers[std::size_t(i)], b = float(ends.nearest(number)) / 7, a = 1 - b;
    aa += a * a, ab += a * b, bb += b * b, ax += a * number, bx += b * number;
  });
  const float determinant = aa * bb - ab * ab;
  if (determinant < 1e-3f) return ends;
  return ordered((bb * ax - ab * bx) / determinant, (aa * bx - ab * ax) / determinant);
}

}  // namespace

std::uint64_t encode_rgtc(const std::array<float, 16>& numbers, std::uint32_t counts) {
  Ends ends = outermost(numbers, counts);
  const Ends better = refitted(ends, numbers, counts);
  if (squared_error(better, numbers, counts) < squared_error(ends, numbers, counts)) ends = better;
  std::uint64_t block = std::uint64_t(ends.first) | std::uint64_t(ends.second) << 8;
  for_counted(counts, [&](int i) {
    const int code = kCodes[std::size_t(ends.nearest(numbers[std::size_t(i)]))];
    block |= std::uint64_t(code) << (16 + 3 * i);
  });
  return block;
}

std::uint8_t decode_rgtc(std::uint64_t block, int i) {
  const Ends ends{int(block & 255), int(block >> 8 & 255)};
  return std::uint8_t(ends.number(kSevenths[std::size_t(block >> (16 + 3 * i) & 7)]));
}

}  // namespace lightbench
