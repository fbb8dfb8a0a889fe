#include "renderer/radiance/piecewise_file.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "base/error.h"
#include "base/files.h"
#include "renderer/radiance/baked_file.h"
#include "renderer/radiance/piecewise_encoder.h"
#include "tests/renderer/radiance/damage.h"
#include "tests/renderer/radiance/random_stacks.h"

namespace lightbench {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr std::array kKinds{"mtnc", "mti", "mtm", "mtsp"};

/// Two texels of six layers: kept at 0, 2, 4 and at 0.
PiecewiseStack small_stack() {
  return {2, 1, {3, 2}, 1, {0, 3}, {0, 2, 4, 0}, {1, 0, 2, 1}, {{0, 0, 0}, {8, 0, 0}, {100, 0, 0}}};
}

bool equal(const PiecewiseStack& a, const PiecewiseStack& b) {
  return a.width == b.width && a.height == b.height && a.grid == b.grid && a.scale == b.scale &&
         a.first_sample == b.first_sample && a.layers == b.layers && a.color_indices == b.color_indices &&
         a.colors == b.colors;
}

class PiecewiseFile : public ::testing::Test {
 protected:
  fs::path file(std::string_view kind) const { return folder.path() / ("wall.1." + std::string(kind)); }
  /// Writes a stack that no encoder makes, and expects that reading blames that file for it.
  void expect_blamed(const char* kind, const PiecewiseStack& stack, const char* what) const {
    write_piecewise(stem, stack);
    EXPECT_THAT([&] { read_piecewise(stem); },
                ThrowsMessage<Error>(AllOf(HasSubstr("wall.1." + std::string(kind)), HasSubstr(what))));
  }

  const TemporaryFolder folder;
  const fs::path stem = folder.path() / "wall.1";
};

TEST_F(PiecewiseFile, FourFilesComeBack) {
  write_piecewise(stem, small_stack());
  EXPECT_TRUE(equal(read_piecewise(stem), small_stack()));
}

TEST_F(PiecewiseFile, ColorsWithoutIndicesComeBack) {
  const PiecewiseStack stack{1, 1, {3, 1}, 2, {0}, {0, 2}, {}, {{3, 0, 0}, {5, 0, 0}}};
  write_piecewise(stem, stack);
  EXPECT_TRUE(equal(read_piecewise(stem), stack));
}

RC_GTEST_PROP(PiecewiseFileProperty, AnyEncodedStackComesBack, ()) {
  const TemporaryFolder folder;
  const PiecewiseStack stack =
      encode_piecewise(any_stack(), *rc::gen::element(SampleRule::greedy, SampleRule::paper), 6);
  write_piecewise(folder.path() / "a", stack);
  RC_ASSERT(equal(read_piecewise(folder.path() / "a"), stack));
}

TEST_F(PiecewiseFile, SizesAreThoseOfTheFiles) {
  write_piecewise(stem, small_stack());
  const std::vector<FileSize> sizes = piecewise_file_sizes(small_stack());
  ASSERT_EQ(sizes.size(), kKinds.size());
  for (const FileSize& size : sizes) EXPECT_EQ(size.bytes, fs::file_size(file(size.name))) << size.name;
}

TEST_F(PiecewiseFile, ADiffuseObjectTakesANinetiethOfItsRawSize) {
  const ByteStack diffuse = random_stack(Content::constant, {20, 20}, 64, 64, 3);
  const PiecewiseStack stack = encode_piecewise(diffuse, SampleRule::greedy, 0);
  // Every texel has a colour of its own: 4 bytes for its start, 2 for its layer, 2 for its index, 3 for its
  // colour, of 1200.
  EXPECT_GT(report_codec(diffuse, decode_piecewise(stack), piecewise_file_sizes(stack)).ratio, 90);
  EXPECT_EQ(decode_piecewise(stack).texels, diffuse.texels);
}

TEST_F(PiecewiseFile, EveryTruncationOfEachIsAnErrorThatNamesIt) {
  write_piecewise(stem, small_stack());
  for (const char* kind : kKinds) {
    const std::string bytes = read_file(file(kind));
    for (std::size_t length = 0; length < bytes.size(); ++length) {
      overwrite(file(kind), bytes.substr(0, length));
      EXPECT_THAT([&] { read_piecewise(stem); }, ThrowsMessage<Error>(HasSubstr(file(kind).string())))
          << length;
    }
    overwrite(file(kind), bytes + '\0');
    EXPECT_THROW(read_piecewise(stem), Error) << kind;
    overwrite(file(kind), bytes);
  }
}

TEST_F(PiecewiseFile, EveryDamagedFieldOfEachIsAnError) {
  write_piecewise(stem, small_stack());
  for (const char* kind : kKinds) {
    const std::string bytes = read_file(file(kind));
    for (const Damage& damage : damaged_headers(bytes)) {
      overwrite(file(kind), damage.bytes);
      EXPECT_THROW(read_piecewise(stem), Error) << kind << ' ' << damage.what;
    }
    overwrite(file(kind), bytes);
  }
}

TEST_F(PiecewiseFile, EveryDamagedByteGivesAnErrorOrAStackThatCanBeDecoded) {
  write_piecewise(stem, small_stack());
  for (const char* kind : kKinds) {
    const std::string bytes = read_file(file(kind));
    for (std::size_t at = 0; at < bytes.size(); ++at)
      for (const int flip : {1, 2, 128, 255}) {
        overwrite(file(kind), with_field(bytes, at, char(bytes[at] ^ flip)));
        try {
          EXPECT_EQ(decode_piecewise(read_piecewise(stem)).texels.size(), 12u);
        } catch (const Error&) {
        }
      }
    overwrite(file(kind), bytes);
  }
}

TEST_F(PiecewiseFile, AMissingFileIsNamed) {
  for (const char* kind : kKinds) {
    write_piecewise(stem, small_stack());
    fs::remove(file(kind));
    EXPECT_THAT([&] { read_piecewise(stem); }, ThrowsMessage<Error>(HasSubstr(file(kind).string())));
  }
}

TEST_F(PiecewiseFile, AFileOfAnotherObjectIsNamed) {
  for (const char* kind : {"mtnc", "mtm", "mtsp"}) {
    write_piecewise(stem, small_stack());
    overwrite(file(kind), with_field<float>(read_file(file(kind)), 40, 2.0f));
    EXPECT_THAT([&] { read_piecewise(stem); },
                ThrowsMessage<Error>(AllOf(HasSubstr(file(kind).string()), HasSubstr("another object"))));
  }
}

TEST_F(PiecewiseFile, CountsMustAgree) {
  PiecewiseStack stack = small_stack();
  stack.color_indices.pop_back();
  expect_blamed("mtnc", stack, "3 entries for 4 samples");
  stack.color_indices.clear();
  expect_blamed("mtm", stack, "3 entries for 4 samples");
  stack = small_stack();
  stack.first_sample.pop_back();
  expect_blamed("mtsp", stack, "1 entries for 2 texels");
  stack = small_stack();
  stack.colors.resize(65537);
  expect_blamed("mtm", stack, "65537 colours");
  stack = small_stack();
  stack.layers.resize(13);
  expect_blamed("mti", stack, "more samples than");
}

TEST_F(PiecewiseFile, FirstSamplesMustRiseFrom0) {
  PiecewiseStack stack = small_stack();
  stack.first_sample = {1, 3};
  expect_blamed("mtsp", stack, "not at 0");
  stack.first_sample = {0, 0};
  expect_blamed("mtsp", stack, "texel 0 has no samples");
  stack.first_sample = {0, 4};
  expect_blamed("mtsp", stack, "starts at sample 4 of 4");
}

TEST_F(PiecewiseFile, LayersOfATexelMustRiseFrom0) {
  PiecewiseStack stack = small_stack();
  stack.layers = {0, 2, 4, 1};
  expect_blamed("mti", stack, "texel 1 does not start at layer 0");
  stack.layers = {0, 2, 2, 0};
  expect_blamed("mti", stack, "texel 0 do not rise");
  stack.layers = {0, 2, 6, 0};
  expect_blamed("mti", stack, "layer 6 of 6");
}

TEST_F(PiecewiseFile, IndicesMustBeOfColors) {
  PiecewiseStack stack = small_stack();
  stack.color_indices[2] = 3;
  expect_blamed("mtnc", stack, "index 3, there are 3 colours");
}

}  // namespace
}  // namespace lightbench
