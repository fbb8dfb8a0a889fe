#include "renderer/paths/power.h"

#include <cmath>

#include <gtest/gtest.h>

namespace lightbench {
namespace {

TEST(Power8, IsNearThePowerOverAllOfItsRange) {
  for (const float y : {0.0f, 0.5f, 1.0f, 5.0f, 40.0f, 400.0f})
    for (int i = 1; i <= 4096; ++i) {
      const float x = float(i) / 4096;
      const double exact = std::pow(double(x), double(y));
      const double got = double(power8(splat(x), splat(y))[3]);
      // As declared; numbers below 2^-126 are 0.
      EXPECT_NEAR(got, exact, exact * (1e-6 + 3e-7 * double(y)) + 0x1p-126) << x << "^" << y;
    }
}

TEST(Power8, OneStaysOne) {
  EXPECT_EQ(power8(splat(1), splat(1000))[0], 1);
}

}  // namespace
}  // namespace lightbench
