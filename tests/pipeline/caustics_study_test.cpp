#include "pipeline/caustics_study.h"

#include <gmock/gmock.h>

namespace lightbench {
namespace {

using testing::HasSubstr;

std::string table_of(const FluxLikeness& likeness) {
  ReceiverFigures figures;
  figures.receiver = "stone";
  figures.light = "sun";
  figures.methods.push_back({"hit", likeness, 0, 0, 0});
  return caustics_tables({{"pond", {figures}}}, 100);
}

TEST(CausticsTables, AReceiverWithoutLightIsSaidToHaveNone) {
  EXPECT_THAT(table_of({std::nullopt, std::nullopt}),
              HasSubstr("| pond | stone | sun | hit | - | no light |"));
}

TEST(CausticsTables, AMapThatMissesAllLightHasNoneOfTheEnergy) {
  EXPECT_THAT(table_of({std::nullopt, 0.0}), HasSubstr("| pond | stone | sun | hit | - | 0.000 |"));
}

TEST(CausticsTables, LikenessHasThreeDigits) {
  EXPECT_THAT(table_of({0.97625, 1.0104}), HasSubstr("| pond | stone | sun | hit | 0.976 | 1.010 |"));
}

}  // namespace
}  // namespace lightbench
