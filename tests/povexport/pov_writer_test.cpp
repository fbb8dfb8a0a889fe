#include "povexport/pov_writer.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <locale>

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "base/error.h"

namespace lightbench {
namespace {

std::string text_of(float value) {
  return PovWriter().number(value).text();
}

RC_GTEST_PROP(PovWriter, NumbersReadBackToTheSameFloat, (std::uint32_t bits)) {
  const float value = std::bit_cast<float>(bits);
  RC_PRE(std::isfinite(value));
  RC_ASSERT(std::strtof(text_of(value).c_str(), nullptr) == value);
}

TEST(PovWriter, NumbersAreShort) {
  EXPECT_EQ(text_of(0.1f), "0.1");
  EXPECT_EQ(text_of(-2.0f), "-2");
  EXPECT_EQ(text_of(1e-20f), "1e-20");
}

TEST(PovWriter, NegativeZeroIsZero) {
  EXPECT_EQ(text_of(-0.0f), "0");
}

TEST(PovWriter, NumbersDoNotDependOnTheLocale) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale old = std::locale::global(std::locale(std::locale(), new Comma));
  const std::string text = text_of(1234.5f);
  std::locale::global(old);
  EXPECT_EQ(text, "1234.5");
}

TEST(PovWriter, NumbersThatAreNotFiniteAreErrors) {
  EXPECT_THROW(text_of(std::numeric_limits<float>::quiet_NaN()), Error);
  EXPECT_THROW(text_of(-std::numeric_limits<float>::infinity()), Error);
  EXPECT_THROW(PovWriter().vector(glm::vec3(0, NAN, 0)), Error);
}

TEST(PovWriter, VectorsStandInAngles) {
  EXPECT_EQ(PovWriter().vector(glm::vec3(1, -0.5f, 0)).text(), "<1,-0.5,0>");
  EXPECT_EQ(PovWriter().vector(glm::vec2(0.25f, 7)).text(), "<0.25,7>");
  EXPECT_EQ(PovWriter().triple({3, 2, 1}).text(), "<3,2,1>");
}

TEST(PovWriter, FileNamesAreNumbered) {
  EXPECT_EQ(pov_file_name("mesh", 7, "inc"), "mesh_0007.inc");
}

}  // namespace
}  // namespace lightbench
