#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lightbench {

/// sRGB-encoded red, green and blue.
using Rgb8 = std::array<std::uint8_t, 3>;

/// The distinct ones of some colours, numbered from 0 in rising order of (red, green, blue). Takes 3 MB.
class ColorSet {
 public:
  explicit ColorSet(std::span<const Rgb8> colors);

  std::size_t size() const { return size_; }
  /// Of a colour that is in the set.
  std::uint32_t number(const Rgb8& color) const;
  /// All, by number.
  std::vector<Rgb8> colors() const;

 private:
  std::vector<std::uint64_t> present_;  ///< one bit for each of the 2^24 colours
  std::vector<std::uint32_t> before_;   ///< how many are present in the words before this one
  std::size_t size_ = 0;
};

}  // namespace lightbench
