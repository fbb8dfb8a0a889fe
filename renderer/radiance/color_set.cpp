#include "renderer/radiance/color_set.h"

#include <bit>

namespace lightbench {
namespace {

constexpr std::size_t kWords = (std::size_t{1} << 24) / 64;

std::uint32_t key_of(const Rgb8& color) {
  return std::uint32_t(color[0]) << 16 | std::uint32_t(color[1]) << 8 | color[2];
}

}  // namespace

ColorSet::ColorSet(std::span<const Rgb8> colors) : present_(kWords), before_(kWords) {
  for (const Rgb8& color : colors) {
    const std::uint32_t key = key_of(color);
    present_[key / 64] |= std::uint64_t{1} << key % 64;
  }
  for (std::size_t word = 0; word < kWords; ++word) {
    before_[word] = std::uint32_t(size_);
    size_ += std::size_t(std::popcount(present_[word]));
  }
}

std::uint32_t ColorSet::number(const Rgb8& color) const {
  const std::uint32_t key = key_of(color);
  const std::uint64_t lower = (std::uint64_t{1} << key % 64) - 1;
  return before_[key / 64] + std::uint32_t(std::popcount(present_[key / 64] & lower));
}

std::vector<Rgb8> ColorSet::colors() const {
  std::vector<Rgb8> colors;
  colors.reserve(size_);
  for (std::size_t word = 0; word < kWords; ++word)
    for (std::uint64_t bits = present_[word]; bits != 0; bits &= bits - 1) {
      const std::size_t key = word * 64 + std::size_t(std::countr_zero(bits));
      colors.push_back({std::uint8_t(key >> 16), std::uint8_t(key >> 8), std::uint8_t(key)});
    }
  return colors;
}

}  // namespace lightbench
