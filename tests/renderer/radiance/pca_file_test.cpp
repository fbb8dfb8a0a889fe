#include "renderer/radiance/pca_file.h"

#include <cstring>

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "renderer/radiance/pca_encoder.h"
#include "tests/renderer/radiance/pca_stacks.h"

namespace lightbench {
namespace {

using namespace test;
using ::testing::HasSubstr;
using ::testing::StartsWith;

PcaStack noise_pca(unsigned seed, int threshold) {
  PcaOptions options;
  options.max_coefficients = 6;
  options.threshold = threshold;
  HalfStack stack = noise_stack(7, 5, {3, 4}, seed);
  stack.scale = 2.5f;
  return encode_pca(stack, {}, options);
}

class PcaFile : public ::testing::Test {
 protected:
  void write(const std::string& bytes) const { write_file_atomic(file_, bytes); }
  std::string bytes_of(const PcaStack& stack) const {
    write_pca(file_, stack);
    return read_file(file_);
  }
  /// The message, or nothing.
  std::string error_of(const std::string& bytes) const {
    write(bytes);
    try {
      read_pca(file_);
      return "";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), StartsWith(file_.string()));
      return error.message();
    }
  }
  template <typename Number>
  std::string error_with(std::string bytes, std::size_t at, Number number) const {
    std::memcpy(bytes.data() + at, &number, sizeof number);
    return error_of(bytes);
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "object.mtpc";
};

TEST_F(PcaFile, IsReadAsItWasWritten) {
  for (const int threshold : {0, 6}) {
    const PcaStack stack = noise_pca(3, threshold);
    write_pca(file_, stack);
    EXPECT_EQ(read_pca(file_), stack);
  }
}

TEST_F(PcaFile, HoldsMatteObjects) {
  const PcaStack stack = encode_pca(
      half_stack(3, 2, {20, 20}, [](int x, int, const glm::vec3&) { return glm::vec3(float(x)); }), {}, {});
  const std::string bytes = bytes_of(stack);
  EXPECT_EQ(read_pca(file_), stack);
  EXPECT_EQ(bytes.size(), 72 + stack.bytes());
}

TEST_F(PcaFile, AnyTruncationIsAnError) {
  const std::string bytes = bytes_of(noise_pca(1, 6));
  for (std::size_t size = 0; size < bytes.size(); size += size < 80 ? 1 : 97)
    EXPECT_THAT(error_of(bytes.substr(0, size)), HasSubstr(size < 72 ? "too short" : "header asks for"));
  EXPECT_THAT(error_of(bytes + "x"), HasSubstr("header asks for"));
}

TEST_F(PcaFile, FieldsOutOfRangeAreNamed) {
  const std::string bytes = bytes_of(noise_pca(1, 6));
  const auto with = [&](std::size_t at, auto number) { return error_with(bytes, at, number); };
  EXPECT_THAT(with(3, 'x'), HasSubstr("not a .mtpc file"));
  EXPECT_THAT(with(8, 2u), HasSubstr("version 2"));
  EXPECT_THAT(with(12, 0u), HasSubstr("width"));
  EXPECT_THAT(with(16, 16385u), HasSubstr("height"));
  EXPECT_THAT(with(20, 1u), HasSubstr("thetas"));
  EXPECT_THAT(with(24, 257u), HasSubstr("phis"));
  EXPECT_THAT(with(28, 3u), HasSubstr("order"));
  EXPECT_THAT(with(32, 2u), HasSubstr("matte"));
  EXPECT_THAT(with(36, 0.0f), HasSubstr("above 0"));
  EXPECT_THAT(with(36, NAN), HasSubstr("finite"));
  EXPECT_THAT(with(40, INFINITY), HasSubstr("offset"));
  EXPECT_THAT(with(44, -INFINITY), HasSubstr("scale"));
  EXPECT_THAT(with(48, 2u), HasSubstr("multiple of 4"));
  EXPECT_THAT(with(52, 0x80000000u), HasSubstr("must be 0 to"));
  EXPECT_THAT(with(56, 3u), HasSubstr("multiple of 2"));
  EXPECT_THAT(with(60, 256u), HasSubstr("step"));
  EXPECT_THAT(with(60, 0u), HasSubstr("without a step"));
  EXPECT_THAT(with(64, 0xffffffffu), HasSubstr("header asks for"));
  EXPECT_THAT(with(68, 1u), HasSubstr("reserved"));
  EXPECT_THAT(with(72, NAN), HasSubstr("coefficient"));
}

TEST_F(PcaFile, CorrectionsThatDoNotFitAreErrors) {
  const PcaStack stack = noise_pca(1, 6);
  ASSERT_GT(stack.corrections.size(), 2u);
  const std::string bytes = bytes_of(stack);
  const std::size_t corrections = bytes.size() - 4 * stack.corrections.size();
  const std::size_t table = corrections - 4 * stack.first_correction.size();
  EXPECT_THAT(error_with(bytes, table, 1u), HasSubstr("first corrections"));
  EXPECT_THAT(error_with(bytes, table + 4, 0xffffffffu), HasSubstr("first corrections"));
  EXPECT_THAT(error_with(bytes, corrections, correction_key(12, 0)), HasSubstr("is not there"));
  EXPECT_THAT(error_with(bytes, corrections, correction_key(11, 15)), HasSubstr("do not rise"));
}

TEST_F(PcaFile, MissingOnesAreErrors) {
  EXPECT_THROW(read_pca(folder_.path() / "none.mtpc"), Error);
}

RC_GTEST_FIXTURE_PROP(PcaFile, WithAnyByteChangedIsRefusedOrDecodes, ()) {
  static const std::string bytes = bytes_of(noise_pca(2, 6));
  std::string changed = bytes;
  changed[*rc::gen::inRange<std::size_t>(0, bytes.size())] = *rc::gen::arbitrary<char>();
  if (error_of(changed).empty()) RC_ASSERT(decode_pca(read_pca(file_)).texels.size() == 7u * 5 * 12);
}

}  // namespace
}  // namespace lightbench
