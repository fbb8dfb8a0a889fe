#include "scene/scene.h"

#include <gtest/gtest.h>

namespace lightbench {
namespace {

TEST(Attenuation, NoneIsOneAtAnyDistance) {
  EXPECT_EQ(attenuation_factor({}, 123.0f), 1.0f);
}

}  // namespace
}  // namespace lightbench
