#include "base/zeroed_allocator.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <vector>

#include <gtest/gtest.h>

namespace lightbench {
namespace {

template <typename T>
using Zeroed = std::vector<T, ZeroedAllocator<T>>;

class ZeroedAllocatorOfSize : public ::testing::TestWithParam<std::size_t> {};

TEST_P(ZeroedAllocatorOfSize, BeginsAsZerosAndIsAVectorOtherwise) {
  // Memory that was in use before, if the allocator gives any again.
  { Zeroed<std::uint32_t>(GetParam(), 7); }
  Zeroed<std::uint32_t> numbers(GetParam());
  EXPECT_EQ(std::ranges::count(numbers, 0u), std::ptrdiff_t(GetParam()));
  numbers.back() = 5;
  numbers.resize(3 * GetParam());
  EXPECT_EQ(numbers[GetParam() - 1], 5u);
  EXPECT_EQ(std::ranges::count(numbers, 0u), std::ptrdiff_t(3 * GetParam() - 1));
  const Zeroed<std::uint32_t> copy = numbers;
  numbers[0] = 9;
  EXPECT_EQ(copy[0], 0u);
  EXPECT_EQ(copy[GetParam() - 1], 5u);
}

INSTANTIATE_TEST_SUITE_P(Bytes, ZeroedAllocatorOfSize, ::testing::Values(2, 1000, std::size_t{3} << 20));

TEST(ZeroedAllocator, FailsAsOthersDo) {
  EXPECT_THROW(allocate_zeroed(std::numeric_limits<std::size_t>::max() / 2), std::bad_alloc);
}

}  // namespace
}  // namespace lightbench
