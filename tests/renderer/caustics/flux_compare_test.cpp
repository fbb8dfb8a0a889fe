#include "renderer/caustics/flux_compare.h"

#include <gtest/gtest.h>

namespace lightbench {
namespace {

FluxField ramp(int size, double factor) {
  FluxField field{size, {}, std::vector<bool>(std::size_t(size * size), true)};
  for (int i = 0; i < size * size; ++i) field.values.push_back(factor * (i % size));
  return field;
}

TEST(FluxCompare, AMultipleIsAlikeAndHasThatEnergy) {
  const FluxLikeness likeness = compare_flux(ramp(8, 2), ramp(8, 1), 1e9);
  EXPECT_NEAR(likeness.correlation.value(), 1, 1e-12);
  EXPECT_NEAR(likeness.energy.value(), 2, 1e-12);
}

TEST(FluxCompare, OnlyTexelsThatCountInBothAreCompared) {
  FluxField map = ramp(8, 1), truth = ramp(8, 1);
  map.values[3] = 1e6;
  map.counts[3] = false;
  truth.values[20] = 1e6;
  truth.counts[20] = false;
  const FluxLikeness likeness = compare_flux(map, truth, 1e9);
  EXPECT_NEAR(likeness.correlation.value(), 1, 1e-12);
  EXPECT_NEAR(likeness.energy.value(), 1, 1e-12);
}

TEST(FluxCompare, ASingleBrightTexelIsClippedButItsEnergyCounts) {
  FluxField map = ramp(16, 1);
  map.values[100] = 1e6;
  const FluxLikeness likeness = compare_flux(map, ramp(16, 1), 20);
  EXPECT_GT(likeness.correlation, 0.7);
  EXPECT_GT(likeness.energy, 100);
}

TEST(FluxCompare, WithoutLightThereIsNoEnergyAndNoCorrelation) {
  const FluxLikeness likeness = compare_flux(ramp(8, 1), ramp(8, 0), 1e9);
  EXPECT_EQ(likeness.energy, std::nullopt);
  EXPECT_EQ(likeness.correlation, std::nullopt);
}

TEST(FluxCompare, ADarkMapOfALitReceiverHasNoneOfItsEnergy) {
  const FluxLikeness likeness = compare_flux(ramp(8, 0), ramp(8, 1), 1e9);
  EXPECT_EQ(likeness.energy, 0);
  EXPECT_EQ(likeness.correlation, std::nullopt);
}

TEST(FluxCompare, WhereNoTexelCountsThereIsNothingToCompare) {
  FluxField map = ramp(8, 1);
  map.counts.assign(64, false);
  const FluxLikeness likeness = compare_flux(map, ramp(8, 1), 1e9);
  EXPECT_EQ(likeness.energy, std::nullopt);
  EXPECT_EQ(likeness.correlation, std::nullopt);
}

TEST(FluxCompare, AMapReadBackIsTurnedOver) {
  Image image(2, 2, 4);
  image.pixel(0, 1)[0] = 7;  // the lower left texel, where w is smallest
  EXPECT_EQ(flux_field(image).values, (std::vector<double>{7, 0, 0, 0}));
}

}  // namespace
}  // namespace lightbench
