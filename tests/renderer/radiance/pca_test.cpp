#include "renderer/radiance/pca.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "renderer/radiance/pca_encoder.h"
#include "tests/renderer/radiance/pca_stacks.h"

namespace lightbench {
namespace {

using namespace test;
using ::testing::ElementsAre;

/// Of 5 x 1 texels and two directions, with one coefficient of each kind that is not 0.
PcaStack small_stack() {
  PcaStack pca{.width = 5, .height = 1, .grid = {2, 1}};
  pca.mean_offset = 10, pca.mean_scale = 65535;
  pca.mean = {0, 0, 0, 90, 90, 90};
  pca.offset.assign(10, 0), pca.scale.assign(10, 0);
  pca.scale[0] = 655.35f, pca.scale[4] = 25.5f, pca.scale[8] = 51;
  pca.offset[4] = 1;
  pca.basis.assign(72, 0);  // of three groups, three components, two directions
  pca.wide.assign(20, 0), pca.narrow.assign(20, 0), pca.blocks.assign(4, 0);
  return pca;
}

TEST(PcaDecoder, AddsAllKindsOfCoefficients) {
  PcaStack pca = small_stack();
  pca.basis[basis_index(pca, 0, 0, 1)] = 32767;   // of red in the second direction
  pca.basis[basis_index(pca, 4, 1, 1)] = -32767;  // of green
  pca.basis[basis_index(pca, 8, 2, 1)] = 32767;   // of blue
  pca.wide[16] = 1000;                            // 10, at texel 4
  pca.narrow[16] = 200;                           // 1 + 20
  pca.blocks[block_index(pca, 1, 0)] = 100;       // 20: one end, which the code 0 stands for
  const PcaDecoder decoder(pca);
  EXPECT_THAT(decoder.value(4, 1), ElementsAre(110, 79, 120));
  EXPECT_THAT(decoder.value(4, 0), ElementsAre(10, 10, 10)) << "the mean alone";
  EXPECT_THAT(decoder.value(3, 1), ElementsAre(100, 99, 100)) << "the offset alone";
}

TEST(PcaDecoder, ClampsSums) {
  PcaStack pca = small_stack();
  pca.basis[basis_index(pca, 0, 0, 0)] = 32767;
  pca.basis[basis_index(pca, 0, 1, 0)] = -32767;
  pca.wide.assign(pca.wide.size(), 65535);
  EXPECT_THAT(PcaDecoder(pca).value(0, 0), ElementsAre(255, 0, 10));
}

TEST(PcaDecoder, AddsCorrectionsOneAfterAnother) {
  PcaStack pca = small_stack();
  pca.correction_step = 3;
  pca.corrections = {pack({correction_key(0, 0), {7, -7, 0}}), pack({correction_key(1, 0), {1, 2, 3}}),
                     pack({correction_key(1, 0), {0, 0, 7}}), pack({correction_key(1, 3), {5, 5, 5}})};
  pca.first_correction = {0, 4, 4};
  const PcaDecoder decoder(pca);
  EXPECT_THAT(decoder.value(0, 0), ElementsAre(31, 0, 10));
  EXPECT_THAT(decoder.value(0, 1), ElementsAre(103, 106, 130));
  EXPECT_THAT(decoder.value(3, 1), ElementsAre(115, 115, 115));
  EXPECT_THAT(decoder.value(4, 1), ElementsAre(100, 100, 100)) << "of another block";
}

RC_GTEST_PROP(PcaCorrection, IsUnpackedAsItWasPacked, ()) {
  PcaCorrection correction{*rc::gen::inRange(0u, 1u << 20), {}};
  for (int& step : correction.steps) step = *rc::gen::inRange(-kMaxCorrection, kMaxCorrection + 1);
  const PcaCorrection unpacked = unpack_correction(pack(correction));
  RC_ASSERT(unpacked.key == correction.key && unpacked.steps == correction.steps);
}

RC_GTEST_PROP(PcaDecoder, GivesSingleValuesAsInTheWhole, ()) {
  const int width = *rc::gen::inRange(1, 10), height = *rc::gen::inRange(1, 7);
  const DirectionGrid grid{*rc::gen::inRange(2, 5), *rc::gen::inRange(1, 6),
                           *rc::gen::element(LayerOrder::theta_major, LayerOrder::phi_serpentine)};
  PcaOptions options;
  options.max_coefficients = 8;
  options.first_bits = *rc::gen::element(8, 16);
  options.threshold = *rc::gen::element(0, 30);
  const HalfStack stack = noise_stack(width, height, grid, *rc::gen::inRange(1u, 1000u));
  const PcaStack pca = encode_pca(stack, {}, options);
  const ByteStack whole = decode_pca(pca);
  const PcaDecoder decoder(pca);
  for (int layer = 0; layer < grid.layers(); ++layer)
    for (std::size_t texel = 0; texel < pca.texels(); ++texel)
      RC_ASSERT(decoder.value(texel, layer) == whole.texels[std::size_t(layer) * pca.texels() + texel]);
}

}  // namespace
}  // namespace lightbench
