#pragma once

#include <array>
#include <cstdint>

/// OpenGL's RGTC compression of one channel: blocks of 4 x 4 numbers in 64 bits, half a byte for a number. A
/// graphics card reads any texel of it, and filters, as it does with plain textures.
namespace lightbench {

inline constexpr int kRgtcSide = 4;

/// Numbers of 0..255 row by row; those whose place is not in `counts` (bit 4 y + x) may become anything.
std::uint64_t encode_rgtc(const std::array<float, 16>& numbers, std::uint32_t counts);

/// Number `i` of a block, 0..255: a weighted mean of the two ends, rounded to nearest. OpenGL does not say
/// how exact it is between the ends; this is within half a step of the exact mean.
std::uint8_t decode_rgtc(std::uint64_t block, int i);

}  // namespace lightbench
